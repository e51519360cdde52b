#include "runner/slurm/time_limit.hpp"

#include <charconv>
#include <vector>

namespace capstan {
namespace {

/// The numbers between colons; empty if the text has another form.
std::vector<int> numbers_in(std::string_view text) {
  std::vector<int> numbers;
  for (;;) {
    int number = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
    if (read.ec != std::errc() || number < 0 || number > 1'000'000) return {};
    numbers.push_back(number);
    text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
    if (text.empty()) return numbers;
    if (text[0] != ':') return {};
    text.remove_prefix(1);
  }
}

}  // namespace

std::optional<std::chrono::minutes> parse_time_limit(const std::string& text) {
  const std::size_t dash = text.find('-');
  const bool has_days = dash != std::string::npos;
  const std::vector<int> days = has_days ? numbers_in(text.substr(0, dash)) : std::vector<int>{0};
  std::vector<int> rest = numbers_in(has_days ? text.substr(dash + 1) : text);
  if (days.size() != 1 || rest.empty() || rest.size() > 3) return std::nullopt;
  if (!has_days && rest.size() < 3) rest.insert(rest.begin(), 0);  // minutes come first, not hours
  rest.resize(3);
  const std::chrono::seconds time = std::chrono::days(days[0]) + std::chrono::hours(rest[0]) +
                                    std::chrono::minutes(rest[1]) + std::chrono::seconds(rest[2]);
  if (time.count() == 0) return std::nullopt;
  return std::chrono::ceil<std::chrono::minutes>(time);
}

}  // namespace capstan
