#include "runner/render/shape_tensors.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace capstan {
namespace {

static_assert(std::endian::native == std::endian::little, "the bytes are sent as they are in memory");

using nlohmann::ordered_json;

class Tensors {
 public:
  template <class Stored, class Values>
  void add(const char* name, const char* type, const ordered_json& shape, const Values& values) {
    const std::size_t begin = data_.size();
    for (const auto value : values) {
      const auto stored = static_cast<Stored>(value);
      data_.append(reinterpret_cast<const char*>(&stored), sizeof stored);
    }
    header_[name] = {{"dtype", type}, {"shape", shape}, {"data_offsets", {begin, data_.size()}}};
  }

  void add_note(const char* name, std::size_t number) {
    header_["__metadata__"][name] = std::to_string(number);
  }

  /// Size of the header, header, data. The header is padded so that all numbers are aligned.
  std::string bytes() const {
    constexpr std::size_t kAlignment = 8;
    std::string header = header_.dump();
    header.resize((header.size() + kAlignment - 1) / kAlignment * kAlignment, ' ');
    const std::uint64_t size = header.size();
    return std::string(reinterpret_cast<const char*>(&size), sizeof size) + header + data_;
  }

 private:
  ordered_json header_;
  std::string data_;
};

using Field = std::vector<double> ShapeArrays::*;

std::vector<double> joined(std::span<const ShapeArrays> shapes, Field field) {
  std::vector<double> all;
  for (const ShapeArrays& shape : shapes) all.insert(all.end(), (shape.*field).begin(), (shape.*field).end());
  return all;
}

bool all_have(std::span<const ShapeArrays> shapes, Field field) {
  return std::ranges::none_of(shapes, [&](const ShapeArrays& shape) { return (shape.*field).empty(); });
}

}  // namespace

std::string as_tensors(const ShapeRange& range, std::span<const ShapeArrays> shapes,
                       std::span<const int> triangles) {
  const std::size_t vertices = shapes.empty() ? 0 : shapes[0].positions.size() / 3;
  const ordered_json vectors = {shapes.size(), vertices, 3}, numbers = {shapes.size(), vertices};
  Tensors tensors;
  tensors.add_note("first", range.first);
  tensors.add_note("total", range.total);
  tensors.add<double>("kt", "F64", {shapes.size()}, range.times);
  tensors.add<float>("positions", "F32", vectors, joined(shapes, &ShapeArrays::positions));
  tensors.add<float>("velocities", "F32", vectors, joined(shapes, &ShapeArrays::velocities));
  tensors.add<float>("forces", "F32", vectors, joined(shapes, &ShapeArrays::forces));
  if (all_have(shapes, &ShapeArrays::stretches))
    tensors.add<float>("stretches", "F32", numbers, joined(shapes, &ShapeArrays::stretches));
  tensors.add<std::uint32_t>("triangles", "U32", {triangles.size() / 3, 3}, triangles);
  return tensors.bytes();
}

}  // namespace capstan
