#pragma once
// Messages about wrong command lines.
#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace capstan {

/// The message, with the name of an unknown command or option and the one that was probably meant, and the
/// --help to read.
std::string usage_error_text(const CLI::App* program, const CLI::Error& error);

}  // namespace capstan
