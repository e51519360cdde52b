#include "runner/cli/pictured_cases.hpp"

#include <algorithm>
#include <iterator>

#include "runner/cli/differing_parameters.hpp"
#include "runner/cli/resolve.hpp"
#include "runner/study/shown_value.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

bool is_fixed(const std::string& parameter, const std::vector<std::string>& at) {
  return std::ranges::any_of(at,
                             [&](const std::string& fixed) { return fixed.starts_with(parameter + "="); });
}

/// Whether the values of an axis, which are objects, differ in this key.
bool varies(const std::string& key, const ordered_json& values) {
  return std::ranges::any_of(values, [&](const ordered_json& value) {
    return !value.is_object() || value.value(key, ordered_json()) != values[0].value(key, ordered_json());
  });
}

/// "Ca = 0.25"; of a value that is an object only what varies along the axis: "tolerance = 0.001".
std::string axis_title(const ordered_json& axis, const ordered_json& value) {
  if (!value.is_object()) return axis["parameter"].get<std::string>() + " = " + shown_value(value);
  std::string title;
  for (const auto& [key, part] : value.items())
    if (varies(key, axis["values"])) title += (title.empty() ? "" : ", ") + key + " = " + shown_value(part);
  return title;
}

/// The values of the axes that vary and are not fixed; the name of the study if there are none.
std::string title_of(const ordered_json& point, const ordered_json& study,
                     const std::vector<std::string>& at) {
  std::string title;
  for (const ordered_json& axis : study["axes"])
    if (axis["values"].size() > 1 && !is_fixed(axis["parameter"], at))
      title += (title.empty() ? "" : ", ") + axis_title(axis, point["asked"][axis["parameter"]]);
  return title.empty() ? study["name"].get<std::string>() : title;
}

bool stands_at(const ordered_json& point, const std::vector<std::string>& at) {
  return std::ranges::all_of(at, [&](const std::string& fixed) {
    const std::string parameter = fixed.substr(0, fixed.find('='));
    return parameter + "=" + shown_value(point["asked"].value(parameter, ordered_json())) == fixed;
  });
}

void add_cases_of_study(Client& client, const std::string& path, const std::vector<std::string>& at,
                        std::vector<PicturedCase>& cases) {
  const ordered_json study = client.get(path);
  for (const ordered_json& point : client.get_all(path + "/cases", "cases"))
    if (stands_at(point, at))
      cases.push_back(
          {title_of(point, study, at), "/v1/cases/" + point["id"].get<std::string>(), point["parameters"]});
}

/// Cases that are named one by one: by the first parameters in which they differ, else by their ids.
void name_by_differences(std::vector<PicturedCase>& cases) {
  constexpr std::size_t kMaxNamed = 3;
  std::vector<ordered_json> parameters;
  for (const PicturedCase& c : cases) parameters.push_back(c.parameters);
  std::vector<std::string> paths = differing_parameters(parameters);
  paths.resize(std::min(paths.size(), kMaxNamed));
  for (PicturedCase& c : cases) {
    std::string title;
    for (const std::string& path : paths)
      if (const ordered_json value = parameter_at(c.parameters, path); !value.is_null())
        title += (title.empty() ? "" : ", ") + name_of_parameter(path) + " = " + shown_value(value);
    c.title = title.empty() ? c.path.substr(c.path.rfind('/') + 1) : title;
  }
}

}  // namespace

std::vector<PicturedCase> pictured_cases(Client& client, const std::vector<std::string>& paths,
                                         const std::vector<std::string>& at) {
  constexpr std::size_t kMaxShown = 28;  // that can be told apart
  std::vector<PicturedCase> cases, single_cases;
  for (const std::string& path : paths)
    if (is_study(path))
      add_cases_of_study(client, path, at, cases);
    else
      single_cases.push_back({"", path, client.get(path)["parameters"]});
  name_by_differences(single_cases);
  std::ranges::move(single_cases, std::back_inserter(cases));
  if (cases.empty()) throw std::invalid_argument("no case of the study has the values of --at");
  if (cases.size() > kMaxShown)
    throw std::invalid_argument(std::to_string(cases.size()) +
                                " cases are too many for one picture, at most " + std::to_string(kMaxShown) +
                                ": fix the value of an axis, as --at V=4");
  return cases;
}

}  // namespace capstan
