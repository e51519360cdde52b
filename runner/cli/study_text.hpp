#pragma once
// Studies and numbers of cases in words.
#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace capstan {

/// "4 cases"; with fewer cases than points "6 points, 2 cases".
std::string size_text(std::size_t points, std::size_t cases);

/// "1 case", "4 queued cases". \param adjective  may be empty
std::string cases_text(std::int64_t count, const std::string& adjective = "");

/// One line for each note.
std::string notes_text(const std::vector<std::string>& notes);

/// The description, state, progress, axes and motions of a study, several lines.
/// \param study  as the server returns it
std::string study_text(const nlohmann::ordered_json& study);

}  // namespace capstan
