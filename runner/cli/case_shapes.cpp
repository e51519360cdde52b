#include "runner/cli/case_shapes.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Arrays with names, in the layout of safetensors files: the size of a JSON header, the header, the numbers.
class Arrays {
 public:
  explicit Arrays(std::string bytes) : bytes_(std::move(bytes)) {
    std::uint64_t size = 0;
    if (bytes_.size() < sizeof size) throw std::runtime_error("the server's shapes have no header");
    std::memcpy(&size, bytes_.data(), sizeof size);
    header_ = ordered_json::parse(bytes_.substr(sizeof size, size));
    data_begin_ = sizeof size + size;
  }

  /// The numbers of an array, which are of the type Stored.
  template <class Stored, class Number>
  std::vector<Number> numbers(const char* name) const {
    const std::size_t begin = header_.at(name).at("data_offsets").at(0);
    const std::size_t end = header_.at(name).at("data_offsets").at(1);
    std::vector<Stored> stored((end - begin) / sizeof(Stored));
    if (data_begin_ + end > bytes_.size()) throw std::runtime_error("the server's shapes are incomplete");
    std::memcpy(stored.data(), bytes_.data() + data_begin_ + begin, stored.size() * sizeof(Stored));
    return {stored.begin(), stored.end()};
  }

  std::size_t note(const char* name) const {
    return std::stoul(header_.at("__metadata__").at(name).get<std::string>());
  }

 private:
  std::string bytes_;
  ordered_json header_;
  std::size_t data_begin_ = 0;
};

std::span<const double> part(const std::vector<double>& all, std::size_t index, std::size_t parts) {
  const std::size_t size = all.size() / parts;
  return {all.data() + index * size, size};
}

/// Returns the number of shapes that were visited.
std::size_t visit_all(const Arrays& arrays, const std::function<void(const VisitedShape& shape)>& visit) {
  const auto times = arrays.numbers<double, double>("kt");
  const auto positions = arrays.numbers<float, double>("positions");
  const auto velocities = arrays.numbers<float, double>("velocities");
  const auto triangles = arrays.numbers<std::uint32_t, int>("triangles");
  for (std::size_t i = 0; i < times.size(); ++i)
    visit({times[i], part(positions, i, times.size()), part(velocities, i, times.size()), triangles});
  return times.size();
}

}  // namespace

void for_each_shape(Client& client, const std::string& case_path,
                    const std::function<void(const VisitedShape& shape)>& visit) {
  for (std::size_t first = 0, total = 1; first < total;) {
    const Arrays arrays(
        client.get_file(case_path + "/shapes", {{"format", "binary"}, {"first", std::to_string(first)}}));
    total = arrays.note("total");
    first += visit_all(arrays, visit);
  }
}

}  // namespace capstan
