#include "runner/queries/queries.hpp"
#include "runner/queries/why.hpp"
#include "runner/render/result_tables.hpp"
#include "runner/web/accept_header.hpp"
#include "runner/web/handlers.hpp"

namespace capstan {
namespace {

Response no_such_case(const std::string& id) {
  return problem(404, "Not found", "there is no case \"" + id + "\"");
}

}  // namespace

Response get_case(Service& service, const httplib::Request&, const std::string& id) {
  const Readers::Reader database = service.reader();
  auto found = find_case(*database, id);
  if (!found) return no_such_case(id);
  add_place(*database, service.places(), *found);
  const std::string self = "/v1/cases/" + id;
  (*found)["links"] = {{"self", self}, {"history", self + "/history"}};
  return json_response(200, *found);
}

Response get_case_why(Service& service, const httplib::Request&, const std::string& id) {
  const Readers::Reader database = service.reader();
  const auto reasons = why(*database, id, service.places());
  return reasons ? json_response(200, *reasons) : no_such_case(id);
}

Response get_case_history(Service& service, const httplib::Request& request, const std::string& id) {
  const Readers::Reader database = service.reader();
  const auto history = find_history(*database, id);
  if (!history) return no_such_case(id);
  Response response =
      wants_csv(request) ? csv_response(as_csv(history_table(*history))) : json_response(200, *history);
  response.headers["Vary"] = "Accept";
  return response;
}

Response get_ids(Service& service, const httplib::Request&, const std::string& word) {
  const Readers::Reader database = service.reader();
  return json_response(200, find_ids(*database, word));
}

}  // namespace capstan
