#pragma once
// Commands that send the same request to the server for each of several studies or cases.
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/cli/client.hpp"

namespace capstan {

/// What a command prints about one study or case: a document with --json, else the text.
struct Answer {
  nlohmann::ordered_json document;
  std::string text;
};

/// Prints what `ask` returns for each target. As text each answer is printed as soon as it is there; as JSON
/// one document if there is one target, else a list of documents. Returns the exit code.
int print_answers(const std::vector<std::string>& targets, bool json,
                  const std::function<Answer(const std::string& target)>& ask);

/// The ids, or the paths on the server, of everything that the user typed. All of it is resolved before the
/// command changes anything.
/// \param resolve  study_id, whole_study_id or path_of_any (resolve.hpp)
std::vector<std::string> resolve_all(
    Client& client, const std::vector<std::string>& typed,
    const std::function<std::string(Client&, const std::string& typed)>& resolve);

}  // namespace capstan
