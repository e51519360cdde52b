#include "runner/cli/write_results.hpp"

#include <iterator>
#include <ostream>
#include <utility>

#include "runner/cli/resolve.hpp"
#include "runner/render/result_columns.hpp"
#include "runner/render/table.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

std::string path_of_cases(const std::string& study_id) { return path_of_study(study_id, "/cases"); }

void look_at_cases(Client& client, const std::string& study_id, ResultColumns& columns) {
  client.for_each_page(path_of_cases(study_id), "cases",
                       [&](const ordered_json& page) { columns.look_at(page); });
}

void write_document(Client& client, const std::string& study_id, std::ostream& out) {
  out << "{\n  \"study\": " << ordered_json(study_id).dump() << ",\n  \"cases\": [";
  const char* separator = "\n";
  client.for_each_page(path_of_cases(study_id), "cases", [&](const ordered_json& page) {
    for (const ordered_json& shown : page) out << std::exchange(separator, ",\n") << shown.dump(2);
  });
  out << "\n  ]\n}";
}

}  // namespace

void write_results_json(Client& client, const std::vector<std::string>& study_ids, std::ostream& out) {
  const bool is_list = study_ids.size() > 1;
  const char* separator = is_list ? "[\n" : "";
  for (const std::string& id : study_ids) {
    out << std::exchange(separator, ",\n");
    write_document(client, id, out);
  }
  out << (is_list ? "\n]\n" : "\n");
}

void write_results_csv(Client& client, const std::vector<std::string>& study_ids, std::ostream& out) {
  ResultColumns seen;
  for (const std::string& id : study_ids) look_at_cases(client, id, seen);
  auto columns = seen.all();
  if (study_ids.size() > 1) columns.insert(columns.begin(), {"study", "study"});
  out << as_csv(table_of(ordered_json::array(), columns));
  for (const std::string& id : study_ids)
    client.for_each_page(path_of_cases(id), "cases", [&](ordered_json page) {
      for (ordered_json& shown : page) shown["study"] = id;
      out << csv_rows(table_of(page, columns));
    });
}

std::string results_text(Client& client, const std::string& study_id) {
  const ordered_json study = client.get(path_of_study(study_id));
  ResultColumns seen;
  look_at_cases(client, study_id, seen);
  const auto columns = seen.summary(study);
  Table table = table_of(ordered_json::array(), columns);
  client.for_each_page(path_of_cases(study_id), "cases", [&](const ordered_json& page) {
    Table part = table_of(page, columns);
    std::move(part.rows.begin(), part.rows.end(), std::back_inserter(table.rows));
  });
  return as_text(table);
}

}  // namespace capstan
