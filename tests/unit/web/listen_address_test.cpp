#include "runner/web/listen_address.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace capstan {
namespace {

TEST(ListenAddress, IsParsedAndPrintedAsUrl) {
  EXPECT_EQ(url_of(parse_listen_address("127.0.0.1:8017")), "http://127.0.0.1:8017");
  EXPECT_EQ(url_of(parse_listen_address("localhost:80")), "http://localhost:80");
  EXPECT_EQ(url_of(parse_listen_address("[::1]:8017")), "http://[::1]:8017");
}

TEST(ListenAddress, IsLoopbackOnlyForThisMachine) {
  for (const char* text : {"127.0.0.1:8017", "127.0.0.2:8017", "127.255.3.4:1", "localhost:80", "[::1]:8017"})
    EXPECT_TRUE(is_loopback(parse_listen_address(text))) << text;
  for (const char* text : {"0.0.0.0:8017", "128.0.0.1:80", "127.0.0.1.evil.example:80", "192.168.1.2:8017",
                           "[::]:8017", "example.org:80"})
    EXPECT_FALSE(is_loopback(parse_listen_address(text))) << text;
}

TEST(ListenAddress, WithoutHostOrValidPortIsRefused) {
  for (const char* text :
       {"127.0.0.1", "127.0.0.1:", "127.0.0.1:http", "127.0.0.1:70000", "127.0.0.1:-1", "", ":8017"})
    EXPECT_THROW(parse_listen_address(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace capstan
