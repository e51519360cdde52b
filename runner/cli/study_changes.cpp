// The commands that change studies: cancel, pause, resume, retry, priority, delete.
#include <charconv>
#include <cstdlib>
#include <stdexcept>

#include "runner/cli/answers.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/resolve.hpp"
#include "runner/cli/study_text.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Cases that a cancelled study still has in the queue, as a part of a sentence; "" if there are none.
std::string remaining_text(std::int64_t cases) {
  if (cases == 0) return "";
  if (cases == 1) return ", 1 is still queued or running: it is about to stop, or another study wants it";
  return ", " + std::to_string(cases) +
         " are still queued or running: they are about to stop, or another study wants them";
}

/// One line that says what a change did.
/// \param study  the server's answer to the change
std::string change_text(const ordered_json& study, const std::string& change) {
  const auto changed = study["changed"].get<std::int64_t>();
  const auto queued = study["cases"]["queued"].get<std::int64_t>();
  const auto running = study["cases"]["running"].get<std::int64_t>();
  const std::string id = study["id"].get<std::string>() + ": ";
  if (change == "cancel")
    return id + "cancelled " + cases_text(changed) + remaining_text(queued + running) + "\n";
  if (change == "pause")
    return id + "paused, " + cases_text(queued, "queued") + " will not start, " + std::to_string(running) +
           " running go on\n";
  if (change == "resume") return id + "resumed, " + cases_text(queued, "queued") + " can start\n";
  if (change == "retry") return id + "queued " + cases_text(changed) + " again\n";
  return id + "priority " + study["priority"].dump() + " for " + cases_text(queued, "queued") + "\n";
}

/// \param body  JSON of the request, or empty
int post_change(const std::string& server, const std::vector<std::string>& typed, bool json,
                const std::string& change, const std::string& body = "") {
  Client client(server);
  const std::vector<std::string> ids = resolve_all(client, typed, study_id);
  return print_answers(ids, json, [&](const std::string& id) {
    const ordered_json study = client.post(path_of_study(id, "/" + change), body);
    return Answer{study, change_text(study, change)};
  });
}

/// Throws std::invalid_argument.
int parse_priority(const std::string& typed) {
  constexpr int kMax = 100;
  int priority = 0;
  const char* const end = typed.data() + typed.size();
  const auto read = std::from_chars(typed.data(), end, priority);
  if (read.ec != std::errc() || read.ptr != end || std::abs(priority) > kMax)
    throw std::invalid_argument("the priority must be a whole number from -100 to 100, is \"" + typed + "\"");
  return priority;
}

/// The name of a preset, or an object of settings.
ordered_json fidelity_of(const std::string& text) {
  const ordered_json object = ordered_json::parse(text, nullptr, false);
  return object.is_object() ? object : ordered_json(text);
}

}  // namespace

int change_studies(const StudyArguments& arguments, const std::string& change) {
  return post_change(arguments.server, arguments.ids, arguments.json, change);
}

int retry_studies(const StudyArguments& arguments) {
  const std::string body = arguments.fidelity
                               ? ordered_json{{"fidelity", fidelity_of(*arguments.fidelity)}}.dump()
                               : std::string();
  return post_change(arguments.server, arguments.ids, arguments.json, "retry", body);
}

int set_priority(const StudyArguments& arguments) {
  std::vector<std::string> studies = arguments.ids;
  const std::string typed = studies.back();
  studies.pop_back();
  const int priority = parse_priority(typed);
  if (studies.empty())
    throw std::invalid_argument("name the study before the priority: capstan priority ID " + typed);
  return post_change(arguments.server, studies, arguments.json, "priority",
                     "{\"priority\": " + std::to_string(priority) + "}");
}

int delete_studies(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> ids = resolve_all(client, arguments.ids, whole_study_id);
  return print_answers(ids, arguments.json, [&](const std::string& id) {
    const ordered_json deletion = client.remove(path_of_study(id));
    const std::string text = id + ": deleted with " +
                             cases_text(deletion["deleted_cases"].get<std::int64_t>()) + ", " +
                             deletion["kept_cases"].dump() + " are kept for other studies\n";
    return Answer{deletion, text};
  });
}

}  // namespace capstan
