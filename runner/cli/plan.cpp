#include <iostream>

#include "runner/cli/commands.hpp"
#include "runner/cli/study_file.hpp"
#include "runner/render/plan_text.hpp"
#include "runner/study/input_file.hpp"
#include "runner/study/study_plan.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {

int plan_file(const FileArguments& arguments) {
  const InputDocument document = parse_document(read_input(arguments.file));
  if (!document.study && !document.single_case) {
    print_issues(std::cerr, input_name(arguments.file), document.issues);
    return kExitInvalidInput;
  }
  const nlohmann::ordered_json plan = plan_json(document);
  std::cout << (arguments.json ? plan.dump(2) + "\n" : plan_text(plan));
  return kExitDone;
}

}  // namespace capstan
