#pragma once
#include <string>

namespace capstan {

/// Warning that a study needs more disk space than is free, or "".
/// \param needed, free  bytes
/// \param runs  directory in which its runs write
std::string disk_warning(double needed, double free, const std::string& runs);

}  // namespace capstan
