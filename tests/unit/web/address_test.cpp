#include "runner/web/address.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace capstan {
namespace {

TEST(Address, OfThisMachineIsAccepted) {
  EXPECT_EQ(url_of(parse_loopback_address("127.0.0.1:8017")), "http://127.0.0.1:8017");
  EXPECT_EQ(url_of(parse_loopback_address("localhost:80")), "http://localhost:80");
  EXPECT_EQ(url_of(parse_loopback_address("[::1]:8017")), "http://[::1]:8017");
}

TEST(Address, ThatOthersCouldReachIsRefused) {
  for (const char* text : {"0.0.0.0:8017", "192.168.1.2:8017", "[::]:8017", "example.org:80", ":8017"})
    EXPECT_THROW(parse_loopback_address(text), std::invalid_argument) << text;
}

TEST(Address, WithoutAGoodPortIsRefused) {
  for (const char* text :
       {"127.0.0.1", "127.0.0.1:", "127.0.0.1:http", "127.0.0.1:70000", "127.0.0.1:-1", ""})
    EXPECT_THROW(parse_loopback_address(text), std::invalid_argument) << text;
}

}  // namespace
}  // namespace capstan
