#include "runner/web/study_events.hpp"

#include <gmock/gmock.h>

#include "tests/unit/web/route_fixture.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class StudyEventsTest : public ServiceFixture {
 protected:
  std::optional<std::string> next(StudyEvents& events) {
    const Readers::Reader database = service_->reader();
    return events.next(*database, clock_.now());
  }
  std::string id_in(const std::string& text) {
    const std::size_t begin = text.find("\nid: ") + 5;
    return text.substr(begin, text.find('\n', begin) - begin);
  }
  void complete_case() {
    service_->tick();
    complete("run 1", "tumbling");
    service_->tick();
  }
  const std::string id_ = service_->submit(sample_study("events", {{"Ca", {0.25}}})).study_id;
};

TEST_F(StudyEventsTest, ChangeIsSentOnceAndTheLastEventEndsTheStream) {
  StudyEvents events(id_, "", clock_.now());
  EXPECT_THAT(*next(events), StartsWith("event: progress\nid: "));
  EXPECT_EQ(*next(events), "");
  complete_case();
  const std::string end = *next(events);
  EXPECT_THAT(end, StartsWith("event: end\n"));
  EXPECT_THAT(end, HasSubstr("\"done\":1"));
  EXPECT_EQ(next(events), std::nullopt);
}

TEST_F(StudyEventsTest, ReconnectingClientMissesNothingAndSeesNothingTwice) {
  StudyEvents first(id_, "", clock_.now());
  const std::string seen = id_in(*next(first));
  StudyEvents again(id_, seen, clock_.now());
  EXPECT_EQ(*next(again), "");
  complete_case();
  StudyEvents later(id_, seen, clock_.now());
  EXPECT_THAT(*next(later), StartsWith("event: end\n"));
}

TEST_F(StudyEventsTest, StreamEndsAfterAMinuteAndAsksTheClientToReconnect) {
  StudyEvents events(id_, "", clock_.now());
  next(events);
  clock_.advance(std::chrono::seconds(59));
  EXPECT_EQ(*next(events), "");
  clock_.advance(std::chrono::seconds(1));
  EXPECT_THAT(*next(events), StartsWith("retry: "));
  EXPECT_EQ(next(events), std::nullopt);
}

TEST_F(StudyEventsTest, ClientThatHasSeenTheLastEventIsToldNotToReconnect) {
  complete_case();
  httplib::Request request = request_for("GET", "/v1/studies/" + id_ + "/events");
  const Response first = respond(*service_, request);
  EXPECT_EQ(first.status, 200);
  request.set_header("Last-Event-ID", id_in(first.next().value()));
  EXPECT_EQ(respond(*service_, request).status, 204);
  request.path = "/v1/studies/nobody/events";
  EXPECT_EQ(respond(*service_, request).status, 404);
}

TEST_F(StudyEventsTest, EventIsOneLineOfJson) {
  StudyEvents events(id_, "", clock_.now());
  const std::string text = *next(events);
  const std::size_t begin = text.find("\ndata: ") + 7;
  const std::string data = text.substr(begin, text.find('\n', begin) - begin);
  EXPECT_EQ(nlohmann::json::parse(data)["id"], id_);
  EXPECT_EQ(text.substr(begin + data.size()), "\n\n");
}

}  // namespace
}  // namespace capstan
