#pragma once
#include <set>
#include <string>
#include <utility>

#include "solver/case/issue.hpp"

namespace capstan {

/// Adds issues to a list, at most one for each pointer: the first.
class IssueCollector {
 public:
  explicit IssueCollector(Issues& issues) : issues_(issues) {}

  void add(const std::string& pointer, std::string message) {
    if (pointers_.insert(pointer).second) issues_.push_back({pointer, std::move(message)});
  }
  bool has_issue(const std::string& pointer) const { return pointers_.contains(pointer); }

  /// The list, for functions that add to it themselves.
  Issues& list() { return issues_; }

 private:
  Issues& issues_;
  std::set<std::string> pointers_;
};

/// Keeps the first 100 issues and counts the others: the list of all could be larger than the document.
inline void limit_number(Issues& issues) {
  constexpr std::size_t kMaxReported = 100;
  if (issues.size() <= kMaxReported) return;
  const std::size_t more = issues.size() - kMaxReported;
  issues.resize(kMaxReported);
  issues.push_back({"", "and " + std::to_string(more) + " more issues"});
}

}  // namespace capstan
