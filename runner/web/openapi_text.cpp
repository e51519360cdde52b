#include "runner/web/openapi_text.hpp"

#include <nlohmann/json.hpp>

#include "runner/web/embedded_documents.hpp"
#include "solver/run_directory/history_line.hpp"

namespace capstan {
namespace {

/// Placeholder in schema/openapi.yaml for the properties of a history.
constexpr std::string_view kPlaceholder =
    "properties: {}  # one for each observable that the database keeps\n";

/// Strings are written as in JSON, which is valid YAML.
std::string property_of(const Observable& observable) {
  const std::string meaning = std::string(observable.description) + ", unit " + std::string(observable.unit);
  return std::string(observable.name) +
         ": {type: array, items: {type: [number, \"null\"]}, description: " + nlohmann::json(meaning).dump() +
         "}\n";
}

std::string history_properties(const std::string& indentation) {
  std::string properties = "properties:\n";
  for (const Observable& observable : kObservables)
    if (observable.is_in_database) properties += indentation + property_of(observable);
  return properties;
}

std::string with_history_properties(std::string document) {
  const std::size_t place = document.find(kPlaceholder);
  if (place == std::string::npos) return document;
  const std::size_t column = place - document.rfind('\n', place) - 1;
  return document.replace(place, kPlaceholder.size(), history_properties(std::string(column + 2, ' ')));
}

}  // namespace

const std::string& openapi_text() {
  static const std::string text = with_history_properties(kOpenApi);
  return text;
}

}  // namespace capstan
