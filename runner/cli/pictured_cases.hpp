#pragma once
// The cases that a picture shows.
#include <string>
#include <vector>

#include "runner/cli/client.hpp"

namespace capstan {

struct PicturedCase {
  std::string title;  ///< for the key of the picture
  std::string path;   ///< on the server
  nlohmann::ordered_json parameters;
};

/// The cases of studies, then single cases, in their order. A case of a study is named by what varies in it:
/// "Ca = 0.25, V = 4"; single cases are named by the parameters in which they differ. Throws
/// std::invalid_argument if there is none, or if there are more than can be told apart.
/// \param paths  of studies and cases on the server
/// \param at     AXIS=VALUE: only the cases of a study that have this value
std::vector<PicturedCase> pictured_cases(Client& client, const std::vector<std::string>& paths,
                                         const std::vector<std::string>& at);

}  // namespace capstan
