#include "runner/queries/metrics.hpp"

namespace capstan {
namespace {

/// One line for each row of the query: label value and number.
std::string counted(Database& database, const std::string& name, const std::string& label, const char* sql) {
  std::string lines;
  Statement row = database.query(sql);
  while (row.step())
    lines += name + "{" + label + "=\"" + row.text(0) + "\"} " + std::to_string(row.integer(1)) + "\n";
  return lines;
}

std::string counted(Database& database, const std::string& name, const char* sql) {
  Statement row = database.query(sql);
  row.step();
  return name + " " + std::to_string(row.integer(0)) + "\n";
}

}  // namespace

std::string metric_description(const std::string& name, const std::string& type, const std::string& help) {
  return "# HELP " + name + " " + help + "\n# TYPE " + name + " " + type + "\n";
}

std::string metrics_text(Database& database, std::size_t cores) {
  return metric_description("capstan_cases", "gauge", "Cases by state.") +
         counted(database, "capstan_cases", "state",
                 "SELECT name, count FROM totals WHERE what = 'cases' AND count > 0") +
         metric_description("capstan_studies", "gauge", "Studies.") +
         counted(database, "capstan_studies", "SELECT count(*) FROM schedule") +
         metric_description("capstan_attempts_total", "counter", "Attempts by the way they ended.") +
         counted(database, "capstan_attempts_total", "ending",
                 "SELECT name, count FROM totals WHERE what = 'attempts'") +
         metric_description("capstan_cores", "gauge", "Cases that may run side by side.") + "capstan_cores " +
         std::to_string(cores) + "\n";
}

}  // namespace capstan
