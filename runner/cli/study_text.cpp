#include "runner/cli/study_text.hpp"

#include "runner/render/printable.hpp"

namespace capstan {

std::string size_text(std::size_t points, std::size_t cases) {
  const std::string text = std::to_string(cases) + (cases == 1 ? " case" : " cases");
  return points == cases ? text : std::to_string(points) + " points, " + text;
}

std::string notes_text(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += "note: " + printable(note) + "\n";
  return text;
}

}  // namespace capstan
