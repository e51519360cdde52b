#include "runner/study/dropped_keys.hpp"

#include <algorithm>

namespace capstan {
namespace {

/// "fidelity.dx" of "/fidelity/dx".
std::string key_of(const std::string& case_pointer) {
  std::string key = case_pointer.substr(1);
  std::replace(key.begin(), key.end(), '/', '.');
  return key;
}

}  // namespace

void DroppedKeys::count_point(const std::vector<AxisValue>& values) {
  ++points_;
  for (const AxisValue& value : values) ++points_with_[value];
}

void DroppedKeys::add(const Issue& issue, const std::string& pointer, const std::optional<AxisValue>& axis) {
  const auto [known, is_new] = dropped_.emplace(pointer, Dropped{issue, 0, axis});
  ++known->second.points;
}

std::size_t DroppedKeys::points_where_it_stands(const Dropped& dropped) const {
  return dropped.axis ? points_with_.at(*dropped.axis) : points_;
}

Issues DroppedKeys::issues() const {
  Issues issues;
  for (const auto& [pointer, dropped] : dropped_)
    if (dropped.points == points_where_it_stands(dropped)) issues.push_back({pointer, dropped.issue.message});
  return issues;
}

std::vector<std::string> DroppedKeys::notes() const {
  std::map<std::string, std::pair<std::size_t, std::string>> keys;  // how often, and why
  for (const auto& [pointer, dropped] : dropped_) {
    auto& [count, why] = keys[key_of(dropped.issue.pointer)];
    count += dropped.points;
    why = dropped.issue.message;
  }
  std::vector<std::string> notes;
  for (const auto& [key, found] : keys)
    notes.push_back(key + " is dropped at " + std::to_string(found.first) + " of " + std::to_string(points_) +
                    " points, where it " + found.second);
  return notes;
}

}  // namespace capstan
