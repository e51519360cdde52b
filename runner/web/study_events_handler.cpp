#include <memory>
#include <thread>

#include "runner/queries/queries.hpp"
#include "runner/web/handlers.hpp"
#include "runner/web/study_events.hpp"

namespace capstan {
namespace {

constexpr std::chrono::milliseconds kInterval{250};  // the daemon reads the histories as often

}  // namespace

/// 204 tells a client that has seen the last event not to reconnect.
Response get_study_events(Service& service, const httplib::Request& request, const std::string& id) {
  const SystemClock clock;
  auto events = std::make_shared<StudyEvents>(id, request.get_header_value("Last-Event-ID"), clock.now());
  const Readers::Reader database = service.reader();
  if (!find_study(*database, id)) return problem(404, "Not found", "there is no study \"" + id + "\"");
  auto first = std::make_shared<std::optional<std::string>>(events->next(*database, clock.now()));
  if (*first == "" && events->is_over()) return {204, "text/event-stream", "", {}};
  Response response{200, "text/event-stream", "", {{"Cache-Control", "no-store"}}};
  response.next = [&service, events, first]() -> std::optional<std::string> {
    if (*first) return std::exchange(*first, std::nullopt);
    std::this_thread::sleep_for(kInterval);
    const Readers::Reader now = service.reader();
    return events->next(*now, SystemClock().now());
  };
  return response;
}

}  // namespace capstan
