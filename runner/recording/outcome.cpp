#include "runner/recording/outcome.hpp"

#include <set>

#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

constexpr int kResultFormat = 1;  // schema/run_directory.md

std::string text_at(const nlohmann::ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

RunOutcome outcome_of_result(nlohmann::ordered_json result) {
  static const std::set<std::string> answers = {"reached_end", "classified", "steady"};
  const auto format = result.find("format");
  if (format != result.end() && *format > kResultFormat)
    return {RunOutcome::Kind::failed,
            "result.json has format " + format->dump() + ", this program reads format " +
                std::to_string(kResultFormat),
            {}};
  const bool has_answer = answers.contains(text_at(result, "stop"));
  if (!has_answer) result["motion"] = nullptr;  // older solvers gave one to failed runs
  std::string message = text_at(result, "message");
  return {has_answer ? RunOutcome::Kind::done : RunOutcome::Kind::diverged, std::move(message),
          std::move(result)};
}

std::string with_log(const std::string& why, const RunDirectory& directory) {
  const std::string said = directory.log_tail();
  return said.empty() ? why : why + "\n" + said;
}

}  // namespace

RunOutcome outcome_of(const ProcessEnd& end, const RunDirectory& directory) {
  if (auto result = directory.result()) return outcome_of_result(std::move(*result));
  using Kind = RunOutcome::Kind;
  if (end.how == ProcessEnd::How::lost) return {Kind::interrupted, "the daemon ended while it ran", {}};
  if (end.how == ProcessEnd::How::exited) {
    switch (end.number) {
      case kExitDone:
        return {Kind::crashed, with_log("it ended well, but left no result.json", directory), {}};
      case kExitInvalidInput:
        return {Kind::failed, with_log("the solver refused the case", directory), {}};
      case kExitNoAnswer:
        return {Kind::diverged, with_log("numerical failure", directory), {}};
      case kExitInterrupted:
        return {Kind::interrupted, "interrupted, a checkpoint is written", {}};
      default:
        break;
    }
  }
  return {Kind::crashed, with_log(describe(end), directory), {}};
}

}  // namespace capstan
