#include <iostream>
#include <memory>

#include "runner/cli/commands.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/execute/exit_code.hpp"

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
    const nlohmann::json value = axis.value(i);
    std::cout << ' ' << (value.is_string() ? value.get<std::string>() : value.dump());
  }
  std::cout << '\n';
}

int validate(const std::string& file) {
  const auto study = read_study_file(file);
  if (!study) return kExitInvalidInput;
  std::cout << "valid: " << study->cases.size() << (study->cases.size() == 1 ? " case\n" : " cases\n");
  for (const Axis& axis : study->axes) print_axis(axis);
  return kExitDone;
}

}  // namespace

Action declare_validate(CLI::App& command) {
  auto file = std::make_shared<std::string>();
  command.add_option("FILE", *file, "the study")->required();
  command.footer("Example:\n  capstan validate studies/quickstart/study.json\n");
  return [file] { return validate(*file); };
}

}  // namespace capstan
