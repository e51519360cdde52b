#include "solver/case/nearest_word.hpp"

#include <algorithm>
#include <cctype>

namespace capstan {
namespace {

constexpr std::size_t kLongest = 40;  // characters; all known words are shorter

/// In lower case, without '-', '_' and spaces.
std::string simplified(std::string_view word) {
  std::string simple;
  for (const unsigned char c : word)
    if (c != '-' && c != '_' && c != ' ') simple += static_cast<char>(std::tolower(c));
  return simple;
}

/// Optimal string alignment: the number of insertions, deletions, substitutions and exchanges of neighbours.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, substituted});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, last);
    std::swap(last, row);
  }
  return last[b.size()];
}

/// Number of typing errors allowed: few for short words, which may be similar by chance.
std::size_t allowed_errors(std::size_t length) {
  return length < 3 ? 0 : length < 6 ? 1 : length < 9 ? 2 : 3;
}

/// The number of typing errors between two words; nothing if there are too many. If the typed word is the
/// beginning of the candidate, the result is one more than the allowed number, so that every other near
/// candidate is preferred.
std::optional<std::size_t> errors_between(const std::string& typed, const std::string& candidate) {
  const std::size_t max_errors = allowed_errors(typed.size());
  const std::size_t errors = edit_distance(typed, candidate);
  if (errors <= max_errors) return errors;
  if (typed.size() >= 3 && candidate.starts_with(typed)) return max_errors + 1;
  return std::nullopt;
}

}  // namespace

std::optional<std::string> nearest_word(std::string_view typed, const std::vector<std::string>& candidates) {
  if (typed.empty() || typed.size() > kLongest) return std::nullopt;
  std::optional<std::string> nearest;
  std::size_t fewest = kLongest;
  for (const std::string& candidate : candidates) {
    const auto errors = errors_between(simplified(typed), simplified(candidate));
    if (!errors || *errors >= fewest) continue;
    fewest = *errors;
    nearest = candidate;
  }
  return nearest;
}

std::string suggestion(std::string_view typed, const std::vector<std::string>& candidates) {
  const auto nearest = nearest_word(typed, candidates);
  return nearest ? "; did you mean \"" + *nearest + "\"?" : "";
}

}  // namespace capstan
