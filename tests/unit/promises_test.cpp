// runner/README.md, "Promises": each test that it names exists.
#include <fnmatch.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>

#include "tests/support/source_directory.hpp"

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// "Suite.Name" of every test in C++, and of those that CMake adds.
std::set<std::string> all_tests() {
  static const std::regex in_cpp(R"(\bTEST(?:_F|_P)?\((\w+),\s*(\w+)\))");
  static const std::regex in_cmake(R"(\badd_test\(NAME (\w+)\.(\w+))");
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(capstan::source_directory() / "tests")) {
    const bool is_cpp = entry.path().extension() == ".cpp";
    if (!is_cpp && entry.path().filename() != "CMakeLists.txt") continue;
    const std::string text = text_of(entry.path());
    for (std::sregex_iterator found(text.begin(), text.end(), is_cpp ? in_cpp : in_cmake), end; found != end;
         ++found)
      names.insert((*found)[1].str() + "." + (*found)[2].str());
  }
  return names;
}

/// From the line "## Promises" to the next heading of that level.
std::string promises() {
  const std::string readme = text_of(capstan::source_directory() / "runner/README.md");
  const std::size_t begin = readme.find("\n## Promises\n");
  if (begin == std::string::npos) return "";
  return readme.substr(begin, readme.find("\n## ", begin + 1) - begin);
}

TEST(Promises, NameTestsThatExist) {
  const std::string section = promises();
  const std::set<std::string> tests = all_tests();
  const std::regex pattern("`([A-Z][A-Za-z]+\\.[A-Za-z0-9*]+)`");
  int count = 0;
  for (std::sregex_iterator found(section.begin(), section.end(), pattern), end; found != end;
       ++found, ++count) {
    const std::string wanted = (*found)[1];
    EXPECT_TRUE(std::any_of(tests.begin(), tests.end(), [&](const std::string& name) {
      return fnmatch(wanted.c_str(), name.c_str(), 0) == 0;
    })) << wanted;
  }
  EXPECT_GT(count, 60);
}

}  // namespace
