#include <filesystem>
#include <memory>

#include "runner/cli/commands.hpp"
#include "runner/execute/local_executor.hpp"

namespace capstan {

Action declare_solve(CLI::App& command, const SolveCase& solve) {
  struct Arguments {
    std::filesystem::path case_file, out;
  };
  auto arguments = std::make_shared<Arguments>();
  command.add_option("CASE", arguments->case_file, "the case, as schema/case.schema.json says")->required();
  command.add_option("--out", arguments->out, "the run directory; made if it is not there")->required();
  command.footer(
      "A run that was killed goes on where it stood when the same command is given again.\n"
      "Example:\n  capstan solve case.json --out runs/first\n");
  return [arguments, solve] {
    end_with_daemon();
    return solve(arguments->case_file, arguments->out);
  };
}

}  // namespace capstan
