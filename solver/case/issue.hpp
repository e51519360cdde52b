#pragma once
#include <string>
#include <vector>

namespace capstan {

/// One thing that is wrong in the user's input.
struct Issue {
  std::string pointer;  ///< RFC 6901, into the document that the user gave
  std::string message;
  bool without_effect = false;  ///< the key has no effect in this case; removing it removes the issue
  bool operator==(const Issue&) const = default;
};
using Issues = std::vector<Issue>;

}  // namespace capstan
