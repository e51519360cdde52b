#include "runner/web/bearer_token.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

constexpr const char* kSecret = "0123456789abcdef";

class BearerTokenTest : public ::testing::Test {
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

TEST_F(BearerTokenTest, IsReadFromTheEnvironmentOrAFileThatItNames) {
  EXPECT_FALSE(token_of_environment());
  name_file(std::string(kSecret) + "\n", std::filesystem::perms::owner_read);
  EXPECT_EQ(token_of_environment(), kSecret);
  setenv("CAPSTAN_TOKEN", "another-token-of-some-length", 1);
  EXPECT_EQ(token_of_environment(), "another-token-of-some-length");
}

TEST_F(BearerTokenTest, InAFileThatOthersCanReadIsRefused) {
  name_file(kSecret, std::filesystem::perms::owner_read | std::filesystem::perms::group_read);
  EXPECT_THROW(token_of_environment(), std::invalid_argument);
}

TEST_F(BearerTokenTest, IsRefusedIfShortOrInvalidInAHeader) {
  for (const char* token :
       {"", "0123456789abcde", "0123456789 abcdef", "0123456789abcdef\x7f", "0123456789abcd\xc3\xa4"}) {
    setenv("CAPSTAN_TOKEN", token, 1);
    EXPECT_THROW(token_of_environment(), std::invalid_argument) << token;
  }
}

}  // namespace
}  // namespace capstan
