#pragma once
// Requests to the routes of a service, without a network.
#include <httplib.h>

#include "runner/web/routes.hpp"
#include "tests/support/service_fixture.hpp"

namespace capstan {

inline httplib::Request request_for(const std::string& method, const std::string& path,
                                    httplib::Params params = {}, const std::string& body = "") {
  httplib::Request request;
  request.method = method;
  request.path = path;
  request.params = std::move(params);
  request.body = body;
  return request;
}

class RouteFixture : public ServiceFixture {
 protected:
  Response ask(const std::string& method, const std::string& path, const std::string& body = "") {
    return respond(*service_, request_for(method, path, {}, body));
  }
  Response get(const std::string& path, httplib::Params query = {}, const std::string& accept = "") {
    httplib::Request request = request_for("GET", path, std::move(query));
    if (!accept.empty()) request.set_header("Accept", accept);
    return respond(*service_, request);
  }
  static nlohmann::ordered_json json(const Response& response) {
    return nlohmann::ordered_json::parse(response.body);
  }

  /// Ca = 0.25 is done, with the motion tumbling; Ca = 0.75 is running. Returns the study's id.
  std::string submit_and_complete_one() {
    const std::string document = study_document("api", {{"Ca", {0.25, 0.75}}, {"V", {4}}}).dump();
    const std::string id = json(ask("POST", "/v1/studies", document))["id"];
    service_->tick();
    write_history("run 1", "{\"kt\":15,\"theta\":0.5}\n{\"kt\":30,\"theta\":-2.5}\n");
    complete("run 1", "tumbling");
    service_->tick();
    return id;
  }
};

}  // namespace capstan
