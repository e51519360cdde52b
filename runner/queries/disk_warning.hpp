#pragma once
#include <string>

namespace capstan {

/// For people: a study that needs more than is free, or "".
/// \param needed, free  bytes  \param runs  where its runs write
std::string disk_warning(double needed, double free, const std::string& runs);

}  // namespace capstan
