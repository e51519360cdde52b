#pragma once
// What each route answers: plain functions from a request to a response.
#include <string>

#include "runner/daemon/service.hpp"
#include "runner/web/message.hpp"

namespace capstan {

/// \param id  the part of the path that names a study or a case, "" on routes without one
using Handler = Response (*)(Service& service, const Request& request, const std::string& id);

Response get_health(Service& service, const Request& request, const std::string& id);
Response get_readiness(Service& service, const Request& request, const std::string& id);
Response get_metrics(Service& service, const Request& request, const std::string& id);
Response get_openapi(Service& service, const Request& request, const std::string& id);
Response get_study_schema(Service& service, const Request& request, const std::string& id);
Response get_case_schema(Service& service, const Request& request, const std::string& id);

Response post_study(Service& service, const Request& request, const std::string& id);
Response get_studies(Service& service, const Request& request, const std::string& id);
Response get_study(Service& service, const Request& request, const std::string& id);
Response delete_study(Service& service, const Request& request, const std::string& id);
Response get_study_cases(Service& service, const Request& request, const std::string& id);
Response get_study_why(Service& service, const Request& request, const std::string& id);
Response get_phase_diagram(Service& service, const Request& request, const std::string& id);
Response get_study_events(Service& service, const Request& request, const std::string& id);
Response cancel_study(Service& service, const Request& request, const std::string& id);
Response pause_study(Service& service, const Request& request, const std::string& id);
Response resume_study(Service& service, const Request& request, const std::string& id);
Response retry_study(Service& service, const Request& request, const std::string& id);
Response set_priority(Service& service, const Request& request, const std::string& id);

Response get_case(Service& service, const Request& request, const std::string& id);
Response get_case_why(Service& service, const Request& request, const std::string& id);
Response get_case_history(Service& service, const Request& request, const std::string& id);

Response get_ids(Service& service, const Request& request, const std::string& word);

}  // namespace capstan
