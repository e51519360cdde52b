#pragma once
// If another case has made the same steps up to an earlier end, a case starts at that end instead of kt = 0.
#include <optional>
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// The done case from whose end this case can go on; of several the one with the longest run. Nothing if
/// there is none.
std::optional<std::string> earlier_run(Database& database, const std::string& case_id);

}  // namespace capstan
