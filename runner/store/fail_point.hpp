#pragma once
// Places where a test kills the daemon: between any two steps that must not be torn apart.
#include <string_view>

namespace capstan {

/// Kills this process with SIGKILL at its Nth passing of the point, if CAPSTAN_FAIL_AT is "NAME:N". The names
/// stand in tests/support/campaign.hpp; one more, "deleted", lies between the rows and the run directories of
/// a deleted study.
void fail_point(std::string_view name);

}  // namespace capstan
