#pragma once
// What distinguishes several cases.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace capstan {

/// The parameters whose values are not the same in all cases, as paths in their JSON: "/Ca",
/// "/fidelity/nodes". \param cases  parameters of each case
std::vector<std::string> differing_parameters(const std::vector<nlohmann::ordered_json>& cases);

/// "/fidelity/nodes" as "fidelity.nodes".
std::string name_of_parameter(const std::string& path);

/// Null if the case has no such parameter.
nlohmann::ordered_json parameter_at(const nlohmann::ordered_json& parameters, const std::string& path);

}  // namespace capstan
