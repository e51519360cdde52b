#include "runner/daemon/free_space.hpp"

#include <system_error>

namespace capstan {

std::string FreeSpace::shortage() const {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(runs_, error);
  if (error)
    return runs_.string() + ", where the runs write, cannot be used (" + error.message() +
           "): nothing is started until it is there again";
  if (space.available >= min_free_) return "";
  return "less than " + std::to_string(min_free_ / 1'000'000) + " MB are free in " + runs_.string() +
         ": nothing is started";
}

}  // namespace capstan
