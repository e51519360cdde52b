#include "solver/observe/history.hpp"

#include <limits>
#include <nlohmann/json.hpp>

namespace capstan {
namespace {

double number(const nlohmann::json& object, const char* key) {
  const nlohmann::json& value = object.at(key);
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

}  // namespace

std::string to_json_line(const Record& r) {
  const nlohmann::ordered_json line = {
      {"kt", r.kt},         {"D_xy", r.D_xy}, {"theta", r.theta},           {"psi", r.psi},
      {"volume", r.volume}, {"area", r.area}, {"iterations", r.iterations}, {"error", r.error}};
  return line.dump();
}

std::optional<Record> parse_record(std::string_view line) {
  try {
    const nlohmann::json j = nlohmann::json::parse(line);
    return Record{number(j, "kt"),
                  number(j, "D_xy"),
                  number(j, "theta"),
                  number(j, "psi"),
                  number(j, "volume"),
                  number(j, "area"),
                  j.at("iterations").get<int>(),
                  number(j, "error")};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

}  // namespace capstan
