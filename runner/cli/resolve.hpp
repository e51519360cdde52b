#pragma once
// What people type for a study or a case: its id, the beginning of it that no other has, or the study's name.
#include <string>

#include "runner/cli/client.hpp"

namespace capstan {

/// The path of the study or the case on the server. Throws Refused (404) if there is none, and
/// std::invalid_argument, with the matches, if there are several.
std::string path_of_any(Client& client, const std::string& typed);

/// The id of the study; throws as path_of_any does.
std::string study_id(Client& client, const std::string& typed);

/// The same for what cannot be undone: the beginning of an id is refused (std::invalid_argument), since given
/// again it can become the beginning of another one.
std::string whole_study_id(Client& client, const std::string& typed);

}  // namespace capstan
