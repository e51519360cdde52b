#pragma once
// The handlers of the routes. Each maps a request to a response, without a network.
#include <httplib.h>

#include <string>

#include "runner/daemon/service.hpp"
#include "runner/web/response.hpp"

namespace capstan {

/// \param id  the decoded segment of the path that stands for "{id}"; "" on routes without one
using Handler = Response (*)(Service& service, const httplib::Request& request, const std::string& id);

Response get_page_file(Service& service, const httplib::Request& request, const std::string& name);

Response get_health(Service& service, const httplib::Request& request, const std::string& id);
Response get_readiness(Service& service, const httplib::Request& request, const std::string& id);
Response get_metrics(Service& service, const httplib::Request& request, const std::string& id);
Response get_openapi(Service& service, const httplib::Request& request, const std::string& id);
Response get_study_schema(Service& service, const httplib::Request& request, const std::string& id);
Response get_case_schema(Service& service, const httplib::Request& request, const std::string& id);

Response post_plan(Service& service, const httplib::Request& request, const std::string& id);
Response post_study(Service& service, const httplib::Request& request, const std::string& id);
Response get_studies(Service& service, const httplib::Request& request, const std::string& id);
Response get_study(Service& service, const httplib::Request& request, const std::string& id);
Response delete_study(Service& service, const httplib::Request& request, const std::string& id);
Response get_study_cases(Service& service, const httplib::Request& request, const std::string& id);
Response get_study_histories(Service& service, const httplib::Request& request, const std::string& id);
Response get_study_why(Service& service, const httplib::Request& request, const std::string& id);
Response get_phase_diagram(Service& service, const httplib::Request& request, const std::string& id);
Response get_boundary(Service& service, const httplib::Request& request, const std::string& id);
Response get_study_events(Service& service, const httplib::Request& request, const std::string& id);
Response cancel_study(Service& service, const httplib::Request& request, const std::string& id);
Response pause_study(Service& service, const httplib::Request& request, const std::string& id);
Response resume_study(Service& service, const httplib::Request& request, const std::string& id);
Response retry_study(Service& service, const httplib::Request& request, const std::string& id);
Response set_priority(Service& service, const httplib::Request& request, const std::string& id);

Response get_case(Service& service, const httplib::Request& request, const std::string& id);
Response get_case_why(Service& service, const httplib::Request& request, const std::string& id);
Response get_case_history(Service& service, const httplib::Request& request, const std::string& id);
Response get_case_shapes(Service& service, const httplib::Request& request, const std::string& id);

Response get_ids(Service& service, const httplib::Request& request, const std::string& word);

}  // namespace capstan
