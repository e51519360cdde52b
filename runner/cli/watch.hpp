#pragma once
#include <iosfwd>
#include <string>

#include "runner/cli/client.hpp"

namespace capstan {

/// Prints the progress of a study until all its cases have ended, then the messages of those that failed.
/// Waits up to two minutes for a server that does not answer: it may be restarting. Returns the exit code:
/// kExitDone if every case is done, else kExitNoAnswer.
/// \param is_terminal  true if `out` is a terminal: then the progress is one line that is rewritten
int watch_study(Client& client, const std::string& study_id, std::ostream& out, bool is_terminal);

}  // namespace capstan
