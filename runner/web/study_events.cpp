#include "runner/web/study_events.hpp"

#include "runner/queries/queries.hpp"
#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

constexpr const char* kReconnect = "retry: 1000\n\n";  // milliseconds until the client reconnects

bool has_ended(const nlohmann::ordered_json& study) {
  return study["cases"]["queued"] == 0 && study["cases"]["running"] == 0;
}

std::string event(const std::string& name, const std::string& id, const std::string& data) {
  return "event: " + name + "\nid: " + id + "\ndata: " + data + "\n\n";
}

}  // namespace

std::optional<std::string> StudyEvents::next(Database& database, Time now) {
  if (is_over_) return std::nullopt;
  const auto study = find_study(database, study_id_);
  if (!study) return std::nullopt;
  is_over_ = has_ended(*study) || now - begin_ >= kMax;
  const std::string data = study->dump();
  const std::string id = sha256_hex(data).substr(0, 16);
  std::string text = is_over_ && !has_ended(*study) ? kReconnect : "";
  if (id != last_id_) text += event(has_ended(*study) ? "end" : "progress", id, data);
  last_id_ = id;
  return text;
}

}  // namespace capstan
