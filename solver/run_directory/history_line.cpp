#include "solver/run_directory/history_line.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace capstan {
namespace {

/// nlohmann::json writes numbers that are not finite as null.
nlohmann::ordered_json value_of(const Observable& observable, double number) {
  if (observable.type == Observable::Type::count && std::isfinite(number))
    return static_cast<std::int64_t>(number);
  return number;
}

}  // namespace

std::string to_json_line(const Record& record, Missing missing) {
  nlohmann::ordered_json line = nlohmann::ordered_json::object();
  for (std::size_t row = 0; row < kObservableCount; ++row) {
    const double number = record.values[row];
    if (missing == Missing::left_out && std::isnan(number)) continue;
    line[std::string(kObservables[row].name)] = value_of(kObservables[row], number);
  }
  return line.dump();
}

std::optional<Record> parse_record(std::string_view line) {
  const nlohmann::json object = nlohmann::json::parse(line, nullptr, false);
  if (!object.is_object()) return std::nullopt;
  Record record;
  for (std::size_t row = 0; row < kObservableCount; ++row) {
    const auto found = object.find(std::string(kObservables[row].name));
    if (found != object.end() && found->is_number()) record.values[row] = found->get<double>();
  }
  return record;
}

}  // namespace capstan
