#include <iostream>

#include "runner/cli/axis_text.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/cli/study_text.hpp"
#include "runner/study/input_file.hpp"
#include "solver/case/case_warnings.hpp"
#include "solver/case/content_id.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

std::vector<ordered_json> values_of(const Axis& axis) {
  std::vector<ordered_json> values;
  for (std::size_t i = 0; i < static_cast<std::size_t>(axis.size()); ++i) values.emplace_back(axis.value(i));
  return values;
}

ordered_json summary_of(const InputDocument& document) {
  if (document.single_case)
    return {{"valid", true},
            {"kind", "case"},
            {"id", case_id(*document.single_case)},
            {"case", to_json(*document.single_case)},
            {"choices", to_json(document.choices)},
            {"warnings", case_warnings(*document.single_case)}};
  if (!document.study) return {{"valid", false}, {"errors", to_json(document.issues)}};
  ordered_json axes = ordered_json::array();
  for (const Axis& axis : document.study->axes)
    axes.push_back({{"parameter", axis.parameter()}, {"values", values_of(axis)}});
  return {{"valid", true},
          {"kind", "study"},
          {"points", document.study->points.size()},
          {"cases", document.study->cases.size()},
          {"axes", axes},
          {"notes", document.study->notes}};
}

void print_study_summary(const Study& study) {
  std::cout << "valid: " << size_text(study.points.size(), study.cases.size()) << '\n';
  for (const Axis& axis : study.axes)
    std::cout << "  " << axis_text(axis.parameter(), values_of(axis)) << '\n';
  std::cout << notes_text(study.notes);
}

void print_case_summary(const Case& c, const Choices& choices) {
  std::cout << "valid: a case, " << case_id(c) << '\n';
  for (const Choice& choice : choices) std::cout << "  " << in_words(choice) << '\n';
  for (const std::string& warning : case_warnings(c)) std::cout << "  warning: " << warning << '\n';
}

}  // namespace

int validate_file(const FileArguments& arguments) {
  const InputDocument document = parse_document(read_input(arguments.file));
  const bool is_valid = document.study || document.single_case;
  if (arguments.json)
    std::cout << summary_of(document).dump(2) << '\n';
  else if (document.study)
    print_study_summary(*document.study);
  else if (document.single_case)
    print_case_summary(*document.single_case, document.choices);
  else
    print_issues(std::cerr, input_name(arguments.file), document.issues);
  return is_valid ? kExitDone : kExitInvalidInput;
}

}  // namespace capstan
