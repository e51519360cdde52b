// README.md, "What the queue promises": each test that it names is there.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "tests/support/source_directory.hpp"

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// "TEST_F(Suite, Name)" of all tests, without the macro.
std::string all_tests() {
  std::string all;
  for (const auto& entry : fs::recursive_directory_iterator(capstan::source_directory() / "tests"))
    if (entry.path().extension() == ".cpp") all += text_of(entry.path());
  return all;
}

TEST(Promises, NameTestsThatExist) {
  const std::string readme = text_of(capstan::source_directory() / "README.md");
  const std::size_t begin = readme.find("## What the queue promises");
  ASSERT_NE(begin, std::string::npos);
  const std::string section = readme.substr(begin, readme.find("\n## ", begin) - begin);
  const std::string tests = all_tests();
  const std::regex name("`([A-Z][A-Za-z]+)\\.([A-Z][A-Za-z]+)`");
  int count = 0;
  for (std::sregex_iterator found(section.begin(), section.end(), name), end; found != end; ++found, ++count)
    EXPECT_NE(tests.find("(" + (*found)[1].str() + ", " + (*found)[2].str() + ")"), std::string::npos)
        << found->str();
  EXPECT_GT(count, 20);
}

}  // namespace
