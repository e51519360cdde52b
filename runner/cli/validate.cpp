#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/execute/exit_code.hpp"
#include "runner/results/table.hpp"

namespace capstan {
namespace {

void print_axis(const Axis& axis) {
  std::cout << "  " << axis.parameter() << ":";
  const auto size = static_cast<std::size_t>(axis.size());
  for (std::size_t i = 0; i < size; ++i) {
    if (i == 6 && size > 8) {
      std::cout << " ...";
      i = size - 1;
    }
    std::cout << ' ' << plain(axis.value(i));
  }
  std::cout << '\n';
}

}  // namespace

int validate_study(const std::string& file) {
  const auto study = read_study_file(file);
  if (!study) return kExitInvalidInput;
  std::cout << "valid: " << study->cases.size() << (study->cases.size() == 1 ? " case\n" : " cases\n");
  for (const Axis& axis : study->axes) print_axis(axis);
  return kExitDone;
}

}  // namespace capstan
