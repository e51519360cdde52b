#include "runner/cli/server_url.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace capstan {
namespace {

using ::testing::HasSubstr;

std::string read(const std::string& text) {
  const ServerUrl url = parse_server_url(text);
  return std::string(url.is_secure ? "https " : "http ") + url.authority() + " " + url.prefix;
}

std::string refusal(const std::string& text) {
  try {
    return "read as " + read(text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(ServerUrl, HasASchemeAHostAndAPort) {
  EXPECT_EQ(read("http://127.0.0.1:8017"), "http 127.0.0.1:8017 ");
  EXPECT_EQ(read("http://example.org"), "http example.org ");
  EXPECT_EQ(read("https://example.org"), "https example.org ");
  EXPECT_EQ(read("http://[fe80::1a]:8017"), "http [fe80::1a]:8017 ");
  EXPECT_EQ(read("localhost:8017"), "http localhost:8017 ");
}

TEST(ServerUrl, SchemeIsReadInCapitals) { EXPECT_EQ(read("HTTPS://Example.org"), "https Example.org "); }

TEST(ServerUrl, PathIsAPrefixWithoutTheLastSlash) {
  EXPECT_EQ(read("http://127.0.0.1:8017/"), "http 127.0.0.1:8017 ");
  EXPECT_EQ(read("https://example.org/lab/capstan/"), "https example.org /lab/capstan");
}

TEST(ServerUrl, AnythingElseIsRefusedWithAnExample) {
  for (const char* text :
       {"", "foo", "ftp://example.org", "http://", "http:///path", "http://a b", "http://::1", "http://[12]",
        "http://example.org:", "http://example.org:80x", "http://user@example.org", "http://example.org/?a=1",
        "http://example.org/#a", "http:/example.org", "/path"})
    EXPECT_THAT(refusal(text), HasSubstr("is no server URL")) << text;
  EXPECT_THAT(refusal("foo"), HasSubstr("http://127.0.0.1:8017"));
  EXPECT_THAT(refusal(std::string(100'000, 'a')), HasSubstr("is no server URL"));
}

TEST(ServerUrl, PortOutOfRangeIsNamed) {
  for (const char* port : {"0", "65536", "99999", "99999999999999999999"})
    EXPECT_THAT(refusal(std::string("http://127.0.0.1:") + port), HasSubstr("port must be from 1 to 65535"))
        << port;
}

}  // namespace
}  // namespace capstan
