#include "runner/study/shown_value.hpp"

#include "solver/case/shown_number.hpp"

namespace capstan {

std::string shown_value(const nlohmann::ordered_json& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return shown(value.get<double>());
  return value.dump();
}

}  // namespace capstan
