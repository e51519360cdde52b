#include "runner/cli/answers.hpp"

#include <iostream>

#include "solver/run_directory/exit_code.hpp"

namespace capstan {
namespace {

bool has_several_lines(const std::string& text) { return text.find('\n') + 1 < text.size(); }

}  // namespace

int print_answers(const std::vector<std::string>& targets, bool json,
                  const std::function<Answer(const std::string& target)>& ask) {
  nlohmann::ordered_json documents = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < targets.size(); ++i) {
    Answer answer = ask(targets[i]);
    if (json)
      documents.push_back(std::move(answer.document));
    else
      std::cout << (i > 0 && has_several_lines(answer.text) ? "\n" : "") << answer.text << std::flush;
  }
  if (json) std::cout << (targets.size() == 1 ? documents.front() : documents).dump(2) << '\n';
  return kExitDone;
}

std::vector<std::string> resolve_all(
    Client& client, const std::vector<std::string>& typed,
    const std::function<std::string(Client&, const std::string& typed)>& resolve) {
  std::vector<std::string> targets;
  for (const std::string& one : typed) targets.push_back(resolve(client, one));
  return targets;
}

}  // namespace capstan
