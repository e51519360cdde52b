#include "runner/study/study_notes.hpp"

#include <algorithm>

#include "runner/study/study_base.hpp"

namespace capstan {
namespace {

constexpr std::size_t kMaxNamed = 4;

/// "a, b, c and 7 more"
std::string listed_in_words(const std::vector<std::string>& texts) {
  std::string words;
  for (std::size_t i = 0; i < std::min(texts.size(), kMaxNamed); ++i) words += (i > 0 ? ", " : "") + texts[i];
  return texts.size() > kMaxNamed ? words + " and " + std::to_string(texts.size() - kMaxNamed) + " more"
                                  : words;
}

void add_repeated_values(const Study& study, std::vector<std::string>& notes) {
  for (const Axis& axis : study.axes) {
    std::vector<std::string> values;
    for (const nlohmann::json& value : axis.repeated()) values.push_back(value.dump());
    if (!values.empty())
      notes.push_back("axis " + axis.parameter() + ": " + listed_in_words(values) +
                      (values.size() == 1 ? " stands" : " stand") + " more than once and counts once");
  }
}

/// \param what  a noun for the sentences, used where they are counted instead of listed
void add_counted(const Study& study, const CountedSentences& sentences, const std::string& what,
                 std::vector<std::string>& notes) {
  std::size_t named = 0;
  for (const auto& [words, points] : sentences) {
    if (named++ == kMaxNamed)
      return notes.push_back("and " + std::to_string(sentences.size() - kMaxNamed) + " more " + what);
    const std::size_t all = study.points.size();
    const std::string where = "at " + std::to_string(points) + " of " + std::to_string(all) + " points ";
    notes.push_back((points < all ? where : "") + words);
  }
}

void add_equal_points(const Study& study, std::vector<std::string>& notes) {
  if (study.points.size() == study.cases.size()) return;
  std::vector<std::size_t> first(study.cases.size());
  std::vector<std::string> equal;
  for (std::size_t point = 0, known = 0; point < study.points.size(); ++point) {
    const std::size_t number = study.points[point];
    if (number == known)
      first[known++] = point;
    else
      equal.push_back("point " + std::to_string(point + 1) + " is the same case as point " +
                      std::to_string(first[number] + 1));
  }
  notes.push_back(std::to_string(study.points.size()) + " points are " + std::to_string(study.cases.size()) +
                  (study.cases.size() == 1 ? " case" : " cases") +
                  ", each computed once: " + listed_in_words(equal));
}

}  // namespace

std::vector<std::string> notes_on(const Study& study, const DroppedKeys& dropped,
                                  const CountedSentences& choices, const CountedSentences& warnings) {
  std::vector<std::string> notes = dropped.notes();
  add_repeated_values(study, notes);
  add_counted(study, choices, "choices of the solver", notes);
  add_counted(study, warnings, "warnings", notes);
  add_equal_points(study, notes);
  if (study.boundary || study.refinement)
    notes.push_back("it begins with " + std::to_string(study.points.size()) +
                    " points; further ones follow where the motion changes");
  if (ends_runs_early(study.document))
    notes.emplace_back(
        "runs end as soon as their label is certain (\"until\": {\"classified\": false} computes all to the "
        "end)");
  return notes;
}

}  // namespace capstan
