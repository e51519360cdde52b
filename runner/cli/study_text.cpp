#include "runner/cli/study_text.hpp"

#include "runner/cli/axis_text.hpp"
#include "runner/cli/progress.hpp"
#include "runner/render/printable.hpp"

namespace capstan {

using nlohmann::ordered_json;

std::string size_text(std::size_t points, std::size_t cases) {
  const std::string text = cases_text(static_cast<std::int64_t>(cases));
  return points == cases ? text : std::to_string(points) + " points, " + text;
}

std::string cases_text(std::int64_t count, const std::string& adjective) {
  return std::to_string(count) + (adjective.empty() ? "" : " " + adjective) +
         (count == 1 ? " case" : " cases");
}

std::string notes_text(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "note: " + printable(note) + "\n";
  return text;
}

std::string study_text(const ordered_json& study) {
  std::string text =
      study["id"].get<std::string>() + "  " + printable(study["description"].get<std::string>()) + "\n";
  text += "submitted " + study["submitted_at"].get<std::string>() + ", " + study["state"].get<std::string>() +
          "\n";
  text += progress_text(study) + "\n";
  const auto points = study["points"].get<std::size_t>(), cases = study["cases"]["total"].get<std::size_t>();
  if (points != cases) text += size_text(points, cases) + "\n";
  for (const ordered_json& axis : study["axes"]) text += axis_text(axis["parameter"], axis["values"]) + "\n";
  for (const auto& [motion, count] : study["motions"].items())
    if (count > 0) text += motion + ": " + count.dump() + (points != cases ? " points\n" : "\n");
  return text + notes_text(study["notes"]);
}

}  // namespace capstan
