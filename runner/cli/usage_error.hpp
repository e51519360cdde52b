#pragma once
// Messages about wrong command lines.
#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace capstan {

/// The message for a wrong command line. It names an unknown command or option, suggests the one that was
/// probably meant, and says which --help to read.
std::string usage_error_text(const CLI::App* program, const CLI::Error& error);

}  // namespace capstan
