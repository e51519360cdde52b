#pragma once
// Finds the study or case that a user means: by its id, by a beginning that no other id has, or by the
// study's name.
#include <string>

#include "runner/cli/client.hpp"

namespace capstan {

/// The path of the study on the server. \param rest  what follows it, such as "/cases"
std::string path_of_study(const std::string& id, const std::string& rest = "");

/// Whether the path on the server is that of a study.
bool is_study(const std::string& path);

/// The path of the study or case on the server. Throws Refused (404) if there is none, and
/// std::invalid_argument, with all matches, if there are several.
std::string path_of_any(Client& client, const std::string& typed);

/// The id of the study; throws as path_of_any does.
std::string study_id(Client& client, const std::string& typed);

/// The id of a study that is to be deleted. Refuses an abbreviated id (std::invalid_argument): once the study
/// is deleted, the same abbreviation could match another study.
std::string whole_study_id(Client& client, const std::string& typed);

}  // namespace capstan
