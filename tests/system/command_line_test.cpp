// The commands as people and scripts use them: what they print, where, and with which exit code.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::MatchesRegex;
using testing::Not;
using testing::StartsWith;

class CommandLineTest : public testing::Test {
 protected:
  std::string file_with(const std::string& text) {
    const std::filesystem::path file = directory_.path() / "study.json";
    std::ofstream(file) << text;
    return file;
  }
  std::string study_file(const nlohmann::json& axes) { return file_with(study_document("cli", axes).dump()); }

  TemporaryDirectory directory_;
};

class ServedCommandLineTest : public CommandLineTest {
 protected:
  CommandResult ask(const std::string& arguments) {
    return run_capstan(arguments + " --server " + daemon_.url());
  }
  std::string submit_and_wait(const nlohmann::json& axes) {
    std::string id = ask("submit " + study_file(axes) + " --watch").output;
    if (!id.empty()) id.pop_back();  // the end of the line
    return id;
  }

  TemporaryDirectory data_;
  Daemon daemon_{data_.path()};
};

TEST_F(CommandLineTest, HelpOfEveryCommandExplainsIt) {
  EXPECT_THAT(run_capstan("--help").output, HasSubstr("phase-diagram"));
  for (const char* command :
       {"serve", "validate", "submit", "watch", "results", "show", "cancel", "phase-diagram", "solve"}) {
    const CommandResult help = run_capstan(std::string(command) + " --help");
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_THAT(help.output, HasSubstr("Example:\n  capstan ")) << command;
  }
}

TEST_F(CommandLineTest, UnknownCommandIsInvalidInput) {
  EXPECT_EQ(run_capstan("fly").exit_code, 2);
  EXPECT_EQ(run_capstan("").exit_code, 2);
  EXPECT_EQ(run_capstan("submit --wrong").exit_code, 2);
}

TEST_F(CommandLineTest, ValidStudyIsSummarised) {
  const CommandResult result = run_capstan("validate " + study_file({{"Ca", {0.25, 0.75}}, {"V", {2, 4}}}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, StartsWith("valid: 4 cases\n"));
}

TEST_F(CommandLineTest, EveryFaultOfAStudyIsPrintedWithItsPointer) {
  const CommandResult result = run_capstan("validate " + study_file({{"Ca", {-1, "a"}}, {"colour", {1}}}));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, IsEmpty());
  for (const char* pointer : {"/axes/Ca/0", "/axes/Ca/1", "/axes/colour"})
    EXPECT_THAT(result.errors, HasSubstr(std::string("\n  ") + pointer + " "));
}

TEST_F(CommandLineTest, FaultyStudyIsRefusedWithoutAServer) {
  EXPECT_EQ(run_capstan("submit " + study_file({{"Ca", {-1}}}) + " --server http://127.0.0.1:9").exit_code,
            2);
  EXPECT_EQ(run_capstan("submit " + file_with("{\"name\": ")).exit_code, 2);
}

TEST_F(CommandLineTest, MissingFileIsNamed) {
  const CommandResult result = run_capstan("validate nowhere.json");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("cannot read nowhere.json: No such file"));
}

TEST_F(CommandLineTest, MissingServerIsExplained) {
  const CommandResult result = run_capstan("studies --server http://127.0.0.1:9");
  EXPECT_EQ(result.exit_code, 69);
  EXPECT_THAT(result.errors, HasSubstr("capstan serve"));
}

TEST_F(CommandLineTest, AddressThatOthersCouldReachIsRefused) {
  const CommandResult result =
      run_capstan("serve --listen 0.0.0.0:8017 --data " + directory_.path().string());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("refusing to listen on 0.0.0.0"));
}

TEST_F(ServedCommandLineTest, SubmitPrintsTheIdAloneAndWatchesOnStandardError) {
  const CommandResult result = ask("submit " + study_file({{"Ca", {0.25, 0.75}}}) + " --watch");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, MatchesRegex("cli-[0-9a-f]{4}\n"));
  EXPECT_THAT(result.errors, HasSubstr("2 of 2 cases\n"));
  EXPECT_THAT(result.errors, Not(HasSubstr("\x1b")));
}

TEST_F(ServedCommandLineTest, StudyWithoutAllAnswersSaysSoInItsExitCode) {
  const CommandResult result = ask("submit " + study_file({{"Ca", {0.25}}, {"V", {4, 50}}}) + " --watch");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors, HasSubstr("diverged: the membrane tore at kt = 0.3"));
}

TEST_F(ServedCommandLineTest, ResultsComeAsTableCsvAndJson) {
  const std::string id = submit_and_wait({{"Ca", {0.25, 0.75}}});
  EXPECT_THAT(ask("results " + id).output, ContainsRegex("0.25 +done +tumbling"));
  EXPECT_THAT(ask("results " + id + " --format csv").output,
              StartsWith("id,state,motion,message,attempt,shape,law,C,Ca,"));
  EXPECT_EQ(nlohmann::json::parse(ask("results " + id + " --format json").output)["cases"].size(), 2u);
}

TEST_F(ServedCommandLineTest, PhaseDiagramIsPlainWhenPiped) {
  const std::string id = submit_and_wait({{"Ca", {0.25, 0.75}}, {"V", {2, 4}}});
  const CommandResult result = ask("phase-diagram " + id);
  EXPECT_THAT(result.output, HasSubstr(" 4 |  TB    TT\n"));
  EXPECT_THAT(result.output, Not(HasSubstr("\x1b")));
}

TEST_F(ServedCommandLineTest, StudiesAreListedAndShown) {
  const std::string id = submit_and_wait({{"Ca", {0.25, 0.75}}});
  EXPECT_THAT(ask("studies").output, HasSubstr(id));
  EXPECT_THAT(ask("show " + id).output, HasSubstr("Ca: 0.25 0.75\ntumbling: 1\ntank_treading: 1\n"));
  EXPECT_EQ(ask("watch " + id).exit_code, 0);
  EXPECT_EQ(ask("cancel " + id).exit_code, 0);
}

TEST_F(ServedCommandLineTest, UnknownStudyIsNotFound) {
  for (const char* command : {"show", "watch", "results", "cancel", "phase-diagram"})
    EXPECT_EQ(ask(std::string(command) + " nobody-0000").exit_code, 4) << command;
}

}  // namespace
}  // namespace capstan
