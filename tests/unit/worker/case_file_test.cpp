#include "runner/worker/case_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <system_error>

#include "tests/support/file_bytes.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::SizeIs;

class CaseFile : public ::testing::Test {
 protected:
  ParsedCase read(const std::string& text) {
    overwrite(file_, text);
    return read_case(file_);
  }

  TemporaryDirectory directory_;
  const std::filesystem::path file_ = directory_.path() / "case.json";
};

TEST_F(CaseFile, ValidCaseIsRead) {
  const ParsedCase parsed = read(R"({"Ca": 0.1})");
  ASSERT_TRUE(parsed.value.has_value());
  EXPECT_EQ(parsed.value->Ca, 0.1);
}

TEST_F(CaseFile, InvalidCaseHasAllItsIssues) {
  const ParsedCase parsed = read(R"({"Ca": -1, "V": -1})");
  EXPECT_FALSE(parsed.value.has_value());
  EXPECT_THAT(parsed.issues, SizeIs(2));
}

TEST_F(CaseFile, TextThatIsNotJsonIsAnIssue) {
  const ParsedCase parsed = read("{");
  EXPECT_FALSE(parsed.value.has_value());
  EXPECT_THAT(parsed.issues, SizeIs(1));
}

TEST_F(CaseFile, StudyIsAnIssueThatNamesTheCommandForStudies) {
  const ParsedCase parsed = read(R"({"base": {"Ca": 0.1}})");
  EXPECT_FALSE(parsed.value.has_value());
  ASSERT_THAT(parsed.issues, SizeIs(1));
  EXPECT_THAT(parsed.issues[0].message, HasSubstr("capstan submit"));
}

TEST_F(CaseFile, MissingFileIsAnExceptionThatNamesIt) {
  try {
    read_case(file_);
    FAIL() << "no exception";
  } catch (const std::system_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(file_.string()));
  }
}

TEST_F(CaseFile, IssuesArePrintedOneALineWithFileAndPointer) {
  ::testing::internal::CaptureStderr();
  print_case_issues(file_, {{"/Ca", "is negative"}, {"", "is no object"}});
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            file_.string() + ": /Ca: is negative\n" + file_.string() + ": is no object\n");
}

}  // namespace
}  // namespace capstan
