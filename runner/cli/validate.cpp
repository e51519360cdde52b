#include <iostream>

#include "runner/cli/axis_text.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/execute/exit_code.hpp"

namespace capstan {
namespace {

std::vector<nlohmann::ordered_json> values_of(const Axis& axis) {
  std::vector<nlohmann::ordered_json> values;
  for (std::size_t i = 0; i < static_cast<std::size_t>(axis.size()); ++i) values.emplace_back(axis.value(i));
  return values;
}

}  // namespace

int validate_study(const std::string& file) {
  const auto study = read_study_file(file);
  if (!study) return kExitInvalidInput;
  std::cout << "valid: " << study->cases.size() << (study->cases.size() == 1 ? " case\n" : " cases\n");
  for (const Axis& axis : study->axes)
    std::cout << "  " << axis_text(axis.parameter(), values_of(axis)) << '\n';
  return kExitDone;
}

}  // namespace capstan
