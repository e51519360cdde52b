#include "runner/web/access_control.hpp"

#include <gtest/gtest.h>

#include "runner/web/request_head.hpp"

namespace capstan {
namespace {

constexpr const char* kToken = "0123456789abcdef";

/// Status of the refusal; 0 if the request is allowed.
int status_of(const AccessControl& access, const std::string& host, const std::string& lines = "",
              const std::string& asked = "GET /v1/studies") {
  const ParsedHead parsed = parse_head(asked + " HTTP/1.1\r\nHost: " + host + "\r\n" + lines + "\r\n");
  EXPECT_FALSE(parsed.refusal);
  const auto refusal = refuse_access(access, parsed.request);
  return refusal ? refusal->status : 0;
}

TEST(AccessControl, AllowsLocalhostNumericAddressesAndListedNames) {
  for (const char* host :
       {"localhost", "LOCALHOST:8017", "127.0.0.1", "127.0.0.1:9000", "[::1]:8017", "[::1]", "10.0.0.7"})
    EXPECT_EQ(status_of({}, host), 0) << host;
  EXPECT_EQ(status_of({{"capsules.example.org"}}, "Capsules.example.org:443"), 0);
}

TEST(AccessControl, RefusesOtherHostNamesAgainstDnsRebinding) {
  for (const char* host :
       {"evil.example", "evil.example:8017", "localhost.evil.example", "127.0.0.1.evil.example", "0x7f000001",
        "127.1", "", "[::1", "localhost:80:80", "user@localhost", "[localhost]"})
    EXPECT_EQ(status_of({{"capsules.example.org"}}, host), 421) << host;
}

TEST(AccessControl, RefusesPagesOfOtherOrigins) {
  const AccessControl named{{"capsules.example.org"}};
  EXPECT_EQ(status_of({}, "localhost:8017", "Origin: http://localhost:8017\r\n"), 0);
  EXPECT_EQ(status_of(named, "127.0.0.1:8017", "Origin: https://capsules.example.org\r\n"), 0);
  for (const char* origin : {"http://evil.example", "null", "http://localhost:3000", "http://127.0.0.1", "",
                             "http://6.6.6.6", "https://capsules.example.org.evil.example"})
    EXPECT_EQ(status_of(named, "localhost:8017", "Origin: " + std::string(origin) + "\r\n"), 403) << origin;
}

TEST(AccessControl, RefusesRequestsWithoutTheToken) {
  const AccessControl guarded{{}, kToken};
  EXPECT_EQ(status_of(guarded, "localhost", "Authorization: Bearer 0123456789abcdef\r\n"), 0);
  EXPECT_EQ(status_of(guarded, "localhost", "authorization: bearer 0123456789abcdef\r\n"), 0);
  EXPECT_EQ(status_of(guarded, "localhost"), 401);
  for (const char* value :
       {"Bearer", "Bearer ", "Bearer 0123456789abcde", "Bearer 0123456789abcdeF", "Bearer 0123456789abcdef0",
        "Bearer  0123456789abcdef", "Basic 0123456789abcdef", "0123456789abcdef", ""})
    EXPECT_EQ(status_of(guarded, "localhost", "Authorization: " + std::string(value) + "\r\n"), 401) << value;
}

TEST(AccessControl, ServesThePageAndNothingElseWithoutTheToken) {
  const AccessControl guarded{{}, kToken};
  for (const char* asked :
       {"GET /", "HEAD /", "GET /page/page.js", "GET /page/page.css", "GET /page/uPlot.js"})
    EXPECT_EQ(status_of(guarded, "localhost", "", asked), 0) << asked;
  for (const char* asked :
       {"POST /", "DELETE /page/page.js", "GET /page/nobody.js", "GET /page/../v1/studies",
        "GET /page/page.js/", "GET //", "GET /healthz", "GET /v1/studies", "POST /v1/studies"})
    EXPECT_EQ(status_of(guarded, "localhost", "", asked), 401) << asked;
}

TEST(AccessControl, ServesThePageToItsOwnHostAndOriginOnly) {
  EXPECT_EQ(status_of({}, "evil.example", "", "GET /"), 421);
  EXPECT_EQ(status_of({}, "localhost:8017", "Origin: http://evil.example\r\n", "GET /page/page.js"), 403);
}

TEST(AccessControl, RefusalNamesTheSchemeOfTheToken) {
  const ParsedHead parsed = parse_head("GET /v1/studies HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(refuse_access({{}, kToken}, parsed.request)->headers.at("WWW-Authenticate"), "Bearer");
}

}  // namespace
}  // namespace capstan
