#include "runner/web/response.hpp"

#include <gmock/gmock.h>

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

TEST(Response, HeadHasStatusLengthAndHeaders) {
  const Response response{201, "application/json", "{}", {{"Location", "/v1/studies/a"}}};
  EXPECT_EQ(response_head(response),
            "HTTP/1.1 201 Created\r\nContent-Type: application/json\r\nContent-Length: 2\r\n"
            "Connection: close\r\nX-Content-Type-Options: nosniff\r\nLocation: /v1/studies/a\r\n\r\n");
}

TEST(Response, HeadOfUnknownStatusHasAnEmptyReasonPhrase) {
  EXPECT_THAT(response_head({299, "text/plain", "", {}}), StartsWith("HTTP/1.1 299 \r\n"));
}

TEST(Response, WithoutContentOrStreamedHasNoLength) {
  Response streamed{200, "text/event-stream", "", {}};
  streamed.next = [] { return std::nullopt; };
  for (const Response& response :
       {Response{204, "text/plain", "", {}}, Response{304, "text/plain", "", {}}, streamed})
    EXPECT_THAT(response_head(response), Not(HasSubstr("Content-Length"))) << response.status;
}

TEST(Response, ProblemListsItsIssues) {
  const Response response =
      problem(422, "Invalid study", "nothing was queued", {{"/axes/Ca/1", "must be positive"}});
  EXPECT_EQ(response.content_type, "application/problem+json");
  const auto body = nlohmann::json::parse(response.body);
  EXPECT_EQ(body["status"], 422);
  EXPECT_EQ(body["errors"][0]["pointer"], "/axes/Ca/1");
  EXPECT_EQ(body["errors"][0]["detail"], "must be positive");
}

}  // namespace
}  // namespace capstan
