#include "runner/cli/watch.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "runner/cli/answers.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/progress.hpp"
#include "runner/cli/resolve.hpp"
#include "runner/render/printable.hpp"
#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

constexpr std::chrono::milliseconds kInterval{500};

int exit_code_of(const ordered_json& cases) {
  return cases["done"] == cases["total"] ? kExitDone : kExitNoAnswer;
}

bool is_not_available(const Refused& refusal) { return refusal.status == 503; }

/// Calls `ask` again and again while the server does not answer or is not available: it may be restarting.
/// Throws the last exception after two minutes, any other one at once.
template <class Ask>
ordered_json ask_patiently(const Ask& ask, std::ostream& out) {
  constexpr std::chrono::seconds kPatience{120};
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  for (bool has_reported = false;; std::this_thread::sleep_for(kInterval)) {
    const bool is_over = std::chrono::steady_clock::now() >= deadline;
    try {
      return ask();
    } catch (const Unreachable&) {
      if (is_over) throw;
    } catch (const Refused& refusal) {
      if (is_over || !is_not_available(refusal)) throw;
    }
    if (!has_reported)
      out << "\nthe server does not answer; trying again for " << kPatience.count() << " s" << std::endl;
    has_reported = true;
  }
}

void report_failures(Client& client, const std::string& study_id, std::ostream& out) {
  for (const char* state : {"failed", "diverged"}) {
    const std::string path = path_of_study(study_id, std::string("/cases?state=") + state);
    for (const ordered_json& shown : ask_patiently([&] { return client.get_all(path, "cases"); }, out))
      out << "case " << shown["id"].get<std::string>() << ' ' << state << ": "
          << printable(shown["message"].get<std::string>()) << '\n';
  }
}

}  // namespace

int watch_study(Client& client, const std::string& study_id, std::ostream& out, bool is_terminal) {
  ProgressLine line(out, is_terminal);
  for (bool was_paused = false;; std::this_thread::sleep_for(kInterval)) {
    const ordered_json study = ask_patiently([&] { return client.get(path_of_study(study_id)); }, out);
    line.show(study);
    const bool is_paused = study["paused"];
    if (is_paused && !was_paused)
      out << "\nthe study is paused, no case is started; go on with:  capstan resume " << study_id
          << std::endl;
    was_paused = is_paused;
    const ordered_json& cases = study["cases"];
    if (cases["queued"] > 0 || cases["running"] > 0) continue;
    line.finish();
    report_failures(client, study_id, out);
    return exit_code_of(cases);
  }
}

int watch_studies(const StudyArguments& arguments) {
  Client client(arguments.server);
  const std::vector<std::string> ids = resolve_all(client, arguments.ids, study_id);
  std::ostream& out = arguments.json ? std::cerr : std::cout;
  const bool is_terminal = isatty(arguments.json ? STDERR_FILENO : STDOUT_FILENO) == 1;
  int code = kExitDone;
  ordered_json studies = ordered_json::array();
  for (const std::string& id : ids) {
    if (ids.size() > 1) out << id << std::endl;
    code = std::max(code, watch_study(client, id, out, is_terminal));
    if (arguments.json) studies.push_back(client.get(path_of_study(id)));
  }
  if (arguments.json) std::cout << (ids.size() == 1 ? studies.front() : studies).dump(2) << '\n';
  return code;
}

}  // namespace capstan
