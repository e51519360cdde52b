#include "runner/web/access.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

constexpr const char* kToken = "0123456789abcdef";

/// 0: may ask.
int status_of(const Access& access, const std::string& host, const std::string& lines = "") {
  const ParsedHead parsed = parse_head("GET / HTTP/1.1\r\nHost: " + host + "\r\n" + lines + "\r\n");
  EXPECT_FALSE(parsed.refusal);
  const auto refusal = refuse_access(access, parsed.head);
  return refusal ? refusal->status : 0;
}

TEST(Access, IsByAddressInDigitsOrByAKnownName) {
  for (const char* host :
       {"localhost", "LOCALHOST:8017", "127.0.0.1", "127.0.0.1:9000", "[::1]:8017", "[::1]", "10.0.0.7"})
    EXPECT_EQ(status_of({}, host), 0) << host;
  EXPECT_EQ(status_of({{"capsules.example.org"}}, "Capsules.example.org:443"), 0);
}

TEST(Access, ThroughANameThatWasMadeToPointHereIsRefused) {
  for (const char* host :
       {"evil.example", "evil.example:8017", "localhost.evil.example", "127.0.0.1.evil.example", "0x7f000001",
        "127.1", "", "[::1", "localhost:80:80", "user@localhost", "[localhost]"})
    EXPECT_EQ(status_of({{"capsules.example.org"}}, host), 421) << host;
}

TEST(Access, OfAPageFromElsewhereIsRefused) {
  const Access named{{"capsules.example.org"}};
  EXPECT_EQ(status_of({}, "localhost:8017", "Origin: http://localhost:8017\r\n"), 0);
  EXPECT_EQ(status_of(named, "127.0.0.1:8017", "Origin: https://capsules.example.org\r\n"), 0);
  for (const char* origin : {"http://evil.example", "null", "http://localhost:3000", "http://127.0.0.1", "",
                             "http://6.6.6.6", "https://capsules.example.org.evil.example"})
    EXPECT_EQ(status_of(named, "localhost:8017", "Origin: " + std::string(origin) + "\r\n"), 403) << origin;
}

TEST(Access, WithoutTheTokenIsRefused) {
  const Access guarded{{}, kToken};
  EXPECT_EQ(status_of(guarded, "localhost", "Authorization: Bearer 0123456789abcdef\r\n"), 0);
  EXPECT_EQ(status_of(guarded, "localhost", "authorization: bearer 0123456789abcdef\r\n"), 0);
  EXPECT_EQ(status_of(guarded, "localhost"), 401);
  for (const char* value :
       {"Bearer", "Bearer ", "Bearer 0123456789abcde", "Bearer 0123456789abcdeF", "Bearer 0123456789abcdef0",
        "Bearer  0123456789abcdef", "Basic 0123456789abcdef", "0123456789abcdef", ""})
    EXPECT_EQ(status_of(guarded, "localhost", "Authorization: " + std::string(value) + "\r\n"), 401) << value;
}

TEST(Access, RefusalSaysHowTheTokenIsSent) {
  const ParsedHead parsed = parse_head("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(refuse_access({{}, kToken}, parsed.head)->headers.at("WWW-Authenticate"), "Bearer");
}

class TokenTest : public testing::Test {
 protected:
  void TearDown() override {
    unsetenv("CAPSTAN_TOKEN");
    unsetenv("CAPSTAN_TOKEN_FILE");
  }
  void name_file(const std::string& content, std::filesystem::perms permissions) {
    const std::filesystem::path file = directory_.path() / "token";
    std::ofstream(file) << content;
    std::filesystem::permissions(file, permissions);
    setenv("CAPSTAN_TOKEN_FILE", file.c_str(), 1);
  }
  TemporaryDirectory directory_;
};

TEST_F(TokenTest, ComesFromTheEnvironmentOrAFileThatItNames) {
  EXPECT_FALSE(token_of_environment());
  name_file(std::string(kToken) + "\n", std::filesystem::perms::owner_read);
  EXPECT_EQ(token_of_environment(), kToken);
  setenv("CAPSTAN_TOKEN", "another-token-of-some-length", 1);
  EXPECT_EQ(token_of_environment(), "another-token-of-some-length");
}

TEST_F(TokenTest, InAFileThatOthersCanReadIsRefused) {
  name_file(kToken, std::filesystem::perms::owner_read | std::filesystem::perms::group_read);
  EXPECT_THROW(token_of_environment(), std::invalid_argument);
}

TEST_F(TokenTest, ThatIsShortOrCannotStandInAHeaderIsRefused) {
  for (const char* token :
       {"", "0123456789abcde", "0123456789 abcdef", "0123456789abcdef\x7f", "0123456789abcd\xc3\xa4"}) {
    setenv("CAPSTAN_TOKEN", token, 1);
    EXPECT_THROW(token_of_environment(), std::invalid_argument) << token;
  }
}

}  // namespace
}  // namespace capstan
