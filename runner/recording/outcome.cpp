#include "runner/recording/outcome.hpp"

#include "solver/run_directory/stop.hpp"

namespace capstan {
namespace {

constexpr int kResultFormat = 1;  // schema/run_directory.md

std::string text_at(const nlohmann::ordered_json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : "";
}

RunOutcome outcome_of_result(nlohmann::ordered_json result) {
  const auto format = result.find("format");
  if (format != result.end() && *format > kResultFormat)
    return {RunEnding::failed, "result.json has format " + format->dump() + ", this program reads format " +
                                   std::to_string(kResultFormat)};
  const std::optional<Stop> stop = parse_word<Stop>(text_at(result, "stop"));
  const bool is_answered = stop && has_answer(*stop);
  if (!is_answered) result["motion"] = nullptr;  // older solvers labelled failed runs, too
  std::string message = text_at(result, "message");
  return {is_answered ? RunEnding::done : RunEnding::diverged, std::move(message), std::move(result)};
}

std::string with_log(const std::string& reason, const RunDirectory& directory) {
  const std::string log = directory.log_tail();
  return log.empty() ? reason : reason + "\n" + log;
}

}  // namespace

RunOutcome outcome_of(const ProcessEnd& end, const RunDirectory& directory) {
  if (auto result = directory.result()) return outcome_of_result(std::move(*result));
  if (end.how == ProcessEnd::How::lost)
    return {RunEnding::interrupted, end.reason.empty() ? "the daemon ended while it ran" : end.reason};
  if (end.how == ProcessEnd::How::signalled) return {RunEnding::crashed, with_log(describe(end), directory)};
  switch (run_ending_of(end.number)) {
    case RunEnding::done:
      return {RunEnding::crashed, with_log("exit code 0, but no result.json", directory)};
    case RunEnding::failed:
      return {RunEnding::failed, with_log("the solver refused the case", directory)};
    case RunEnding::diverged:
      return {RunEnding::diverged, with_log("numerical failure", directory)};
    case RunEnding::interrupted:
      return {RunEnding::interrupted, "interrupted, a checkpoint is written"};
    case RunEnding::crashed:
      break;
  }
  return {RunEnding::crashed, with_log(describe(end), directory)};
}

}  // namespace capstan
