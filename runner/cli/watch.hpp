#pragma once
#include <iosfwd>
#include <string>

#include "runner/cli/client.hpp"

namespace capstan {

/// Shows the progress of a study, which the server has just been asked for, until all its cases have ended;
/// the exit code says whether all have an answer. A server that is being restarted is waited for.
int watch_study(Client& client, const std::string& study_id, std::ostream& out, bool is_terminal);

}  // namespace capstan
