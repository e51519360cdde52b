#pragma once
// What is wrong with a command line, in words.
#include <string>

namespace CLI {
class App;
class Error;
}  // namespace CLI

namespace capstan {

/// An unknown command or option is named, with the one that was probably meant.
std::string usage_fault(const CLI::App* program, const CLI::Error& error);

}  // namespace capstan
