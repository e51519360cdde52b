#pragma once
// Points between two steps of the daemon at which a test can kill it.
#include <string_view>

namespace capstan {

/// Kills this process with SIGKILL when it passes the point for the Nth time, if the environment variable
/// CAPSTAN_FAIL_AT is "NAME:N". tests/support/campaign.hpp lists the names. One more, "deleted", is passed
/// when the rows of deleted cases are gone and their run directories are still there.
void fail_point(std::string_view name);

}  // namespace capstan
