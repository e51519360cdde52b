#pragma once
// A case whose steps another case has made already, to an earlier end, goes on from there.
#include <optional>
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// The done case from whose end this case can go on; of several the one with the longest run. Nothing if
/// there is none.
std::optional<std::string> earlier_run(Database& database, const std::string& case_id);

}  // namespace capstan
