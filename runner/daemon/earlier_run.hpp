#pragma once
// A case can start from the last state of another one instead of from kt = 0, if both take the same steps and
// the other one ended earlier.
#include <optional>
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// The done case from whose end this case can go on; of several the one with the longest run. Nothing if
/// there is none.
std::optional<std::string> earlier_run(Database& database, const std::string& case_id);

}  // namespace capstan
