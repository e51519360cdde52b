#include "runner/cli/differing_parameters.hpp"

#include <algorithm>

namespace capstan {

using nlohmann::ordered_json;

std::vector<std::string> differing_parameters(const std::vector<ordered_json>& cases) {
  std::vector<std::string> paths;
  for (const ordered_json& parameters : cases) {
    const ordered_json flat = parameters.flatten();
    for (const auto& entry : flat.items()) {
      const std::string& path = entry.key();
      const ordered_json value = parameter_at(parameters, path);
      const auto differs = [&](const ordered_json& other) { return parameter_at(other, path) != value; };
      if (std::ranges::find(paths, path) == paths.end() && std::ranges::any_of(cases, differs))
        paths.push_back(path);
    }
  }
  return paths;
}

std::string name_of_parameter(const std::string& path) {
  std::string name = path.substr(1);
  std::ranges::replace(name, '/', '.');
  return name;
}

ordered_json parameter_at(const ordered_json& parameters, const std::string& path) {
  return parameters.value(ordered_json::json_pointer(path), ordered_json());
}

}  // namespace capstan
