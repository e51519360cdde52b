// The commands of the real program: standard output, standard error and exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>

#include "tests/support/program.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

class CommandLineTest : public ::testing::Test {
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
    if (!id.empty()) id.pop_back();  // the newline
    return id;
  }

  TemporaryDirectory data_;
  Daemon daemon_{data_.path()};
};

TEST_F(CommandLineTest, HelpOfEveryCommandExplainsIt) {
  EXPECT_THAT(run_capstan("--help").output, HasSubstr("phase-diagram"));
  for (const char* command : {"serve", "validate", "plan", "fidelity", "submit", "watch", "results", "show",
                              "cancel", "phase-diagram", "solve"}) {
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

TEST_F(CommandLineTest, UnknownWordsAreNamedWithTheNearestKnownOne) {
  const auto errors = [](const std::string& arguments) { return run_capstan(arguments).errors; };
  EXPECT_THAT(errors("sumbit study.json"),
              HasSubstr("no command \"capstan sumbit\"; did you mean \"submit\"?"));
  EXPECT_THAT(errors("result x --format csv"),
              HasSubstr("no command \"capstan result\"; did you mean \"results\"?"));
  EXPECT_THAT(errors("fly"), HasSubstr("no command \"capstan fly\"\n"));
  EXPECT_THAT(errors("show x --sever y"),
              HasSubstr("capstan show has no option --sever; did you mean \"--server\"?"));
  EXPECT_THAT(errors("show x --jsno=1"), HasSubstr("has no option --jsno; did you mean \"--json\"?"));
  EXPECT_THAT(errors("validate a b"), HasSubstr("capstan validate takes no further argument \"b\""));
  EXPECT_THAT(errors("show"), HasSubstr("ID is required"));
}

TEST_F(CommandLineTest, VersionNamesProgramAndNumerics) {
  const CommandResult result = run_capstan("--version");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, MatchesRegex("capstan [0-9.]+\nnumerics [0-9]+\n"));
}

TEST_F(CommandLineTest, OutputThatCannotBeWrittenIsAnError) {
  const std::string validate = "validate " + study_file({{"Ca", {0.25}}});
  for (const std::string& arguments :
       {std::string("--help"), std::string("--version"), validate, validate + " --json"})
    for (const char* place : {">/dev/full", ">&-"}) {
      const CommandResult result = run_capstan(arguments, place);
      EXPECT_EQ(result.exit_code, 1) << arguments << place;
      EXPECT_THAT(result.errors, HasSubstr("cannot write to standard output")) << arguments << place;
    }
  EXPECT_EQ(run_capstan("validate nowhere.json", ">/dev/full").exit_code, 1);
  EXPECT_EQ(run_capstan("fly", ">/dev/full").exit_code, 2);
}

TEST_F(CommandLineTest, ServerThatCannotPrintItsAddressEnds) {
  const CommandResult result =
      run_capstan("serve --listen 127.0.0.1:0 --data " + (directory_.path() / "data").string(), ">/dev/full");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("cannot write to standard output"));
}

TEST_F(CommandLineTest, ReaderThatClosesThePipeIsNotReported) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  close(ends[0]);
  const auto before = std::signal(SIGPIPE, SIG_IGN);  // the command inherits it
  const CommandResult result = run_capstan("--help", ">&" + std::to_string(ends[1]));
  std::signal(SIGPIPE, before);
  close(ends[1]);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, IsEmpty());
}

TEST_F(CommandLineTest, DatabaseIsNotOpenedInPlaceOfAClosedStandardOutput) {
  const CommandResult result = run_capstan("doctor --data " + directory_.path().string(), ">&- 2>&- <&-");
  EXPECT_EQ(result.exit_code, 1);
}

TEST_F(CommandLineTest, DirectoryInPlaceOfAFileIsAnErrorThatSaysSo) {
  const std::string directory = directory_.path().string();
  EXPECT_EQ(run_capstan("validate " + directory).errors,
            "capstan: cannot read " + directory + ": Is a directory\n");
}

TEST_F(CommandLineTest, CaseIsValidatedAsACase) {
  const CommandResult valid = run_capstan("validate " + file_with(R"({"shape": "sphere", "Ca": 0.1})"));
  EXPECT_EQ(valid.exit_code, 0);
  EXPECT_THAT(valid.output, ContainsRegex("^valid: a case, [0-9a-f]{16}\n  fluid: auto became stokes: "));
  const CommandResult invalid = run_capstan("validate " + file_with(R"({"shape": "sphere", "Ca": -1})"));
  EXPECT_EQ(invalid.exit_code, 2);
  EXPECT_THAT(invalid.errors, HasSubstr("1 issue\n  /Ca  is -1"));
}

TEST_F(CommandLineTest, CaseIsNotSubmitted) {
  const CommandResult result =
      run_capstan("submit " + file_with(R"({"Ca": 0.1})") + " --server http://127.0.0.1:9");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("this is a case, not a study"));
}

TEST_F(CommandLineTest, DashNamesStandardInput) {
  const CommandResult result = run_capstan("validate -", "<" + study_file({{"Ca", {0.25, 0.75}}}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, StartsWith("valid: 2 cases\n"));
  const CommandResult invalid = run_capstan("validate -", "</dev/null");
  EXPECT_EQ(invalid.exit_code, 2);
  EXPECT_THAT(invalid.errors, StartsWith("standard input: 1 issue"));
}

TEST_F(CommandLineTest, ValidatePrintsJsonOnRequest) {
  const auto validate = [&](const std::string& file) {
    return nlohmann::json::parse(run_capstan("validate --json " + file).output);
  };
  const nlohmann::json study = validate(study_file({{"Ca", {0.25, 0.75}}}));
  EXPECT_EQ(study["kind"], "study");
  EXPECT_EQ(study["cases"], 2);
  EXPECT_EQ(validate(file_with(R"({"Ca": 0.1})"))["case"]["Ca"], 0.1);
  const nlohmann::json invalid = validate(file_with(R"({"Ca": -1})"));
  EXPECT_EQ(invalid["valid"], false);
  EXPECT_EQ(invalid["errors"][0]["pointer"], "/Ca");
}

TEST_F(CommandLineTest, PlanSaysWhatACaseModelsAndCosts) {
  const std::string file = file_with(R"({"shape": "biconcave", "Ca": 0.25, "V": 4, "fidelity": "fast"})");
  const CommandResult text = run_capstan("plan " + file);
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.output, ContainsRegex("^case [0-9a-f]{16}\n  modelled\n    capsule: biconcave"));
  EXPECT_THAT(text.output, ContainsRegex("expected cost\n    [0-9.]+ s of one core, "));
  const auto plan = nlohmann::json::parse(run_capstan("plan --json " + file).output);
  for (const nlohmann::json& part : plan["groups"][0]["left_out"])
    EXPECT_THAT(text.output, HasSubstr("    " + part.get<std::string>() + "\n"));
}

TEST_F(CommandLineTest, PlanOfAStudyCountsItsCases) {
  const CommandResult text = run_capstan("plan -", "<" + study_file({{"Ca", {0.25, 0.75}}, {"V", {1, 4}}}));
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.output, ContainsRegex("^study cli: 4 cases, [0-9.]+ s of one core \\("));
  EXPECT_THAT(text.output, HasSubstr("\n2 cases\n  modelled\n"));
}

TEST_F(CommandLineTest, PlanOfAnInvalidFileListsItsIssues) {
  const CommandResult result = run_capstan("plan " + file_with(R"({"Ca": -1, "V": "thick"})"));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("2 issues\n"));
  EXPECT_THAT(result.output, IsEmpty());
}

TEST_F(CommandLineTest, FidelityListsThePresetsWithTheirCostAndError) {
  const CommandResult text = run_capstan("fidelity");
  EXPECT_THAT(text.output, ContainsRegex("standard +2562 +0.1 "));
  const auto document = nlohmann::json::parse(run_capstan("fidelity --json").output);
  EXPECT_EQ(document["presets"].size(), 4u);
  for (const nlohmann::json& result : document["results"])
    EXPECT_THAT(text.output, ContainsRegex(result["preset"].get<std::string>() + " +" +
                                           result["fluid"].get<std::string>() + " +[0-9]"));
}

TEST_F(CommandLineTest, MalformedServerUrlIsInvalidInput) {
  for (const char* url : {"foo", "http://127.0.0.1:99999", "ftp://127.0.0.1", "http://"}) {
    const CommandResult result = run_capstan(std::string("studies --server ") + url);
    EXPECT_EQ(result.exit_code, 2) << url;
    EXPECT_THAT(result.errors, HasSubstr("is no server URL")) << url;
    EXPECT_THAT(result.errors, HasSubstr("http://127.0.0.1:8017")) << url;
  }
}

TEST_F(CommandLineTest, ValidStudyIsSummarised) {
  const CommandResult result = run_capstan("validate " + study_file({{"Ca", {0.25, 0.75}}, {"V", {2, 4}}}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, StartsWith("valid: 4 cases\n"));
}

TEST_F(CommandLineTest, EveryIssueOfAStudyIsPrintedWithItsPointer) {
  const CommandResult result = run_capstan("validate " + study_file({{"Ca", {-1, "a"}}, {"colour", {1}}}));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, IsEmpty());
  for (const char* pointer : {"/axes/Ca/0", "/axes/Ca/1", "/axes/colour"})
    EXPECT_THAT(result.errors, HasSubstr(std::string("\n  ") + pointer + " "));
}

TEST_F(CommandLineTest, InvalidStudyIsRefusedWithoutAServer) {
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

TEST_F(CommandLineTest, AddressThatOtherMachinesReachIsRefusedWithoutAToken) {
  const CommandResult result =
      run_capstan("serve --listen 0.0.0.0:8017 --data " + directory_.path().string());
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("refusing to listen on 0.0.0.0"));
}

TEST_F(ServedCommandLineTest, SubmitPrintsOnlyTheIdAndWatchesOnStandardError) {
  const CommandResult result = ask("submit " + study_file({{"Ca", {0.25, 0.75}}}) + " --watch");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, MatchesRegex("cli-[0-9a-f]{4}\n"));
  EXPECT_THAT(result.errors, HasSubstr("2 of 2 cases\n"));
  EXPECT_THAT(result.errors, Not(HasSubstr("\x1b")));
}

TEST_F(ServedCommandLineTest, ExitCodeIs3IfACaseHasNoAnswer) {
  const CommandResult result = ask("submit " + study_file({{"Ca", {0.25}}, {"V", {4, 50}}}) + " --watch");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors, HasSubstr("diverged: the membrane tore at kt = 0.3"));
}

TEST_F(ServedCommandLineTest, ResultsComeAsTableCsvAndJson) {
  const std::string id = submit_and_wait({{"Ca", {0.25, 0.75}}});
  EXPECT_THAT(ask("results " + id).output, ContainsRegex("0.25 +done +tumbling"));
  EXPECT_THAT(ask("results " + id + " --format csv").output,
              StartsWith("id,state,motion,message,attempt,point,"));
  EXPECT_EQ(nlohmann::json::parse(ask("results " + id + " --format json").output)["cases"].size(), 2u);
}

TEST_F(ServedCommandLineTest, HistoriesOfSeveralCasesBeginWithWhatDistinguishesThem) {
  const std::string id = submit_and_wait({{"Ca", {0.25, 0.75}}});
  std::string ids;
  const auto results = nlohmann::json::parse(ask("results " + id + " --json").output);
  for (const auto& shown : results["cases"]) ids += " " + shown["id"].get<std::string>();
  const std::string table = ask("history" + ids).output;
  EXPECT_THAT(table, StartsWith("case,Ca,kt,D_xy,"));
  for (const char* value : {"0.25", "0.75"})
    EXPECT_THAT(table, ContainsRegex(std::string("\n[0-9a-f]+,") + value + ","));
  EXPECT_THAT(ask("history" + ids.substr(0, 17)).output, StartsWith("kt,D_xy,"));
}

TEST_F(ServedCommandLineTest, StudyWithoutABoundaryIsAnsweredWithWhatOneNeeds) {
  const CommandResult refused = ask("boundary " + submit_and_wait({{"Ca", {0.25}}}));
  EXPECT_EQ(refused.exit_code, 4);
  EXPECT_THAT(refused.errors, HasSubstr("\"boundary\": {\"along\""));
  EXPECT_THAT(refused.errors, HasSubstr("capstan results"));
}

TEST_F(ServedCommandLineTest, FileInAMissingFolderIsRefusedBeforeAnythingIsAsked) {
  for (const char* command : {"figure nobody -o none/a.svg", "shape nobody -o none/a.vtp"}) {
    const CommandResult refused = ask(command);
    EXPECT_EQ(refused.exit_code, 2) << command;
    EXPECT_THAT(refused.errors, HasSubstr("there is no folder"));
  }
}

TEST_F(ServedCommandLineTest, PhaseDiagramOfThreeAxesFixesOne) {
  const std::string id = submit_and_wait({{"Ca", {0.25, 0.75}}, {"V", {2, 4}}, {"E_b", {0, 0.015}}});
  const CommandResult refused = ask("phase-diagram " + id);
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors,
              HasSubstr("E_b is not fixed: say at which value, such as E_b=0; it has: 0, 0.015"));
  const CommandResult drawn = ask("phase-diagram " + id + " --x V --y Ca --at E_b=0.015");
  EXPECT_EQ(drawn.exit_code, 0) << drawn.errors;
  EXPECT_THAT(drawn.output, HasSubstr("\nat E_b = 0.015\n"));
}

TEST_F(ServedCommandLineTest, PointsThatShareACaseAreNotedAndAllListed) {
  const std::string file = file_with(R"({"name": "merged", "base": {"Ca": 0.25, "fluid": "stokes"},
      "axes": {"Re": [0, 0.05]}})");
  EXPECT_THAT(run_capstan("validate " + file).output, StartsWith("valid: 2 points, 1 case\n"));
  const CommandResult submitted = ask("submit " + file + " --watch");
  EXPECT_THAT(submitted.errors,
              HasSubstr("note: 2 points are 1 case, each computed once: point 2 is the same case as "
                        "point 1\n"));
  const std::string id = submitted.output.substr(0, submitted.output.size() - 1);
  EXPECT_THAT(ask("show " + id).output, HasSubstr("2 points, 1 case\n"));
  EXPECT_THAT(ask("results " + id).output, ContainsRegex("\n +2 .* 1 +0.05 "));
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
  EXPECT_EQ(ask("show ../../healthz").exit_code, 4);
}

TEST_F(ServedCommandLineTest, EveryAnswerThatCannotBeWrittenIsAnError) {
  const std::string file = study_file({{"Ca", {0.25}}});
  std::string id = ask("submit " + file + " --watch").output;
  id.pop_back();
  for (const std::string& command :
       {std::string("studies"), "show " + id, "results " + id, "results " + id + " --format csv",
        "results " + id + " --json", "phase-diagram " + id, "watch " + id, "why " + id, "submit " + file,
        "retry " + id, "pause " + id, "resume " + id, "priority " + id + " 1", "cancel " + id,
        "backup " + (directory_.path() / "copy").string() + " --data " + data_.path().string()}) {
    const std::string server = command.starts_with("backup") ? "" : " --server " + daemon_.url();
    const CommandResult result = run_capstan(command + server, ">/dev/full");
    EXPECT_EQ(result.exit_code, 1) << command;
    EXPECT_THAT(result.errors, HasSubstr("cannot write to standard output")) << command;
  }
}

TEST_F(ServedCommandLineTest, ServerIsFoundByEveryFormOfItsUrl) {
  const std::string authority = daemon_.url().substr(std::string("http://").size());
  for (const std::string& url : {"http://" + authority + "/", "HTTP://" + authority, authority})
    EXPECT_EQ(run_capstan("studies --server " + url).exit_code, 0) << url;
  EXPECT_EQ(run_capstan("studies --server http://" + authority + "/lab").exit_code,
            4);  // no proxy takes the prefix off
}

TEST_F(ServedCommandLineTest, EnvironmentNamesTheServer) {
  setenv("CAPSTAN_SERVER", daemon_.url().c_str(), 1);
  const CommandResult result = run_capstan("studies");
  unsetenv("CAPSTAN_SERVER");
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(run_capstan("studies --help").output, HasSubstr("CAPSTAN_SERVER"));
}

TEST_F(ServedCommandLineTest, StudyIsFoundByItsNameOrTheBeginningOfItsId) {
  const std::string id = submit_and_wait({{"Ca", {0.25, 0.75}}});
  for (const std::string& typed : {std::string("cli"), std::string("CL"), id.substr(0, 5), id})
    EXPECT_THAT(ask("show " + typed).output, StartsWith(id)) << typed;
  const nlohmann::json cases = nlohmann::json::parse(ask("results cli --json").output)["cases"];
  const std::string case_id = cases[0]["id"];
  EXPECT_THAT(ask("why " + case_id.substr(0, 12)).output, StartsWith(case_id + ": done\n"));
}

TEST_F(ServedCommandLineTest, AmbiguousIdIsRefusedWithAllItsMatches) {
  const std::string first = submit_and_wait({{"Ca", {0.25}}}), second = submit_and_wait({{"Ca", {0.75}}});
  const CommandResult result = ask("cancel cli");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("\n  " + first));
  EXPECT_THAT(result.errors, HasSubstr("\n  " + second));
}

TEST_F(ServedCommandLineTest, CommandsTakeSeveralStudies) {
  const std::string first = submit_and_wait({{"Ca", {0.25}}}), second = submit_and_wait({{"Ca", {0.75}}});
  const std::string both = first + " " + second;
  for (const char* command :
       {"show", "results", "phase-diagram", "why", "pause", "resume", "retry", "cancel"}) {
    const CommandResult text = ask(std::string(command) + " " + both);
    EXPECT_EQ(text.exit_code, 0) << command;
    EXPECT_THAT(text.output, HasSubstr(first)) << command;
    EXPECT_THAT(text.output, HasSubstr(second)) << command;
    EXPECT_EQ(nlohmann::json::parse(ask(std::string(command) + " --json " + both).output).size(), 2u)
        << command;
  }
  EXPECT_EQ(ask("cancel " + first + " nobody-0000").exit_code, 4);
  EXPECT_THAT(ask("priority " + both + " 7").output,
              AllOf(HasSubstr(first + ": priority 7"), HasSubstr(second + ": priority 7")));
  EXPECT_THAT(ask("watch " + both).output, AllOf(HasSubstr(first), HasSubstr(second)));
  EXPECT_EQ(nlohmann::json::parse(ask("watch --json " + both).output).size(), 2u);
  EXPECT_THAT(ask("results --format csv " + both).output,
              AllOf(StartsWith("study,id,"), HasSubstr("\n" + first + ","), HasSubstr("\n" + second + ",")));
}

TEST_F(ServedCommandLineTest, CancellingAStudyThatIsDoneLeavesItDone) {
  const std::string id = submit_and_wait({{"Ca", {0.25}}});
  EXPECT_EQ(ask("cancel " + id).output, id + ": cancelled 0 cases\n");
  EXPECT_EQ(nlohmann::json::parse(ask("show --json " + id).output)["state"], "done");
}

TEST_F(ServedCommandLineTest, InvalidOptionOfAChangeIsInvalidInput) {
  const std::string id = submit_and_wait({{"Ca", {0.25}}});
  for (const char* bad : {"retry --fidelity Fine ", "retry --fidelity '' "})
    EXPECT_EQ(ask(bad + id).exit_code, 2) << bad;
  for (const char* bad : {" ten", " 101", " 1.5"}) {
    const CommandResult result = ask("priority " + id + bad);
    EXPECT_EQ(result.exit_code, 2) << bad;
    EXPECT_THAT(result.errors, HasSubstr("-100")) << bad;
  }
}

TEST_F(ServedCommandLineTest, EveryResultComesAsOneJsonDocument) {
  const std::string file = study_file({{"Ca", {0.25, 0.75}}});
  const auto answer = [&](const std::string& arguments) {
    return nlohmann::json::parse(ask(arguments + " --json").output);
  };
  const std::string id = answer("submit --watch " + file)["id"];
  EXPECT_EQ(answer("submit " + file)["id"], id);
  EXPECT_EQ(answer("studies")["studies"][0]["id"], id);
  EXPECT_EQ(answer("show " + id)["cases"]["done"], 2);
  EXPECT_EQ(answer("watch " + id)["state"], "done");
  EXPECT_EQ(answer("results " + id)["cases"].size(), 2u);
  EXPECT_EQ(answer("phase-diagram " + id)["x"]["parameter"], "Ca");
  EXPECT_EQ(answer("why " + id)["reasons"][0]["cases"], 2);
  EXPECT_EQ(answer("priority " + id + " 3")["priority"], 3);
  EXPECT_EQ(answer("cancel " + id)["changed"], 0);
  const CommandResult copy = run_capstan("backup --json " + (directory_.path() / "copy").string() +
                                         " --data " + data_.path().string());
  EXPECT_TRUE(nlohmann::json::parse(copy.output).contains("file"));
}

TEST_F(ServedCommandLineTest, ChangesPrintTheNumberOfTheirCases) {
  std::string id =
      ask("submit " + study_file({{"Ca", {0.25}}, {"V", {70, 71, 72, 73, 40}}})).output;  // three run
  id.pop_back();
  EXPECT_THAT(ask("pause " + id).output,
              ContainsRegex("^" + id + ": paused, [0-9]+ queued cases? will not start"));
  EXPECT_THAT(ask("studies").output, ContainsRegex(id + " +(paused|running)"));
  EXPECT_THAT(ask("priority " + id + " 7").output, ContainsRegex(": priority 7 for [0-9]+ queued case"));
  EXPECT_THAT(ask("resume " + id).output, ContainsRegex(": resumed, [0-9]+ queued cases? can start"));
  EXPECT_THAT(ask("cancel " + id).output,
              ContainsRegex(": cancelled [0-9]+ cases?(, [0-9]+ (is|are) still queued or running: |\n)"));
  EXPECT_EQ(ask("watch " + id).exit_code, 3);
  const CommandResult list = ask("studies");
  EXPECT_THAT(list.output, HasSubstr("cancelled"));
  EXPECT_THAT(list.output, Not(HasSubstr("100 %")));
}

TEST_F(ServedCommandLineTest, StudyIsExplainedByTheReasonsOfItsCases) {
  const std::string id = submit_and_wait({{"Ca", {0.25, 0.3}}, {"V", {4, 50}}});
  const CommandResult result = ask("why " + id);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, StartsWith(id + ": done\n"));
  EXPECT_THAT(result.output, HasSubstr("  2 cases: done, with an answer\n"));
  EXPECT_THAT(result.output, HasSubstr("  2 cases: diverged: the membrane tore at kt = 0.3 (case "));
}

TEST_F(ServedCommandLineTest, ResultsOfSeveralPagesAreOneDocumentAndOneTable) {
  constexpr std::size_t kCases = 1100;
  std::string id =
      ask("submit " + study_file({{"Ca", {{"from", 0.1}, {"to", 1}, {"count", kCases}}}, {"V", {70}}}))
          .output;
  id.pop_back();
  EXPECT_EQ(nlohmann::json::parse(ask("results " + id + " --json").output)["cases"].size(), kCases);
  EXPECT_EQ(nlohmann::json::parse(ask("results " + id + " " + id + " --json").output).size(), 2u);
  for (const char* format : {"csv", "table"}) {
    const std::string text = ask("results " + id + " --format " + format).output;
    EXPECT_EQ(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')), kCases + 1) << format;
  }
}

TEST_F(ServedCommandLineTest, EscapeSequencesOfADescriptionDoNotReachTheTerminal) {
  nlohmann::json document = study_document("cli", {{"Ca", {0.25}}});
  document["description"] = "\x1b[2J\x1b]0;title\x07 over\rwritten";
  std::string id = ask("submit " + file_with(document.dump())).output;
  id.pop_back();
  for (const std::string command : {"studies", "show", "watch"}) {
    const CommandResult result = ask(command == "studies" ? command : command + " " + id);
    EXPECT_EQ(result.output.find_first_of("\x1b\x07\r"), std::string::npos) << command;
  }
  EXPECT_THAT(ask("show " + id).output, HasSubstr("?[2J?]0;title? over?written"));
  document["base"]["\x1b[2J"] = 1;
  EXPECT_EQ(run_capstan("validate " + file_with(document.dump())).errors.find('\x1b'), std::string::npos);
}

TEST_F(ServedCommandLineTest, StudyIsDeletedWithItsResults) {
  const std::string id = submit_and_wait({{"Ca", {0.25, 0.3}}});
  EXPECT_THAT(run_capstan("disk --data " + data_.path().string()).output, ContainsRegex(id + " +2 +[0-9.]+"));
  const auto usage = nlohmann::json::parse(run_capstan("disk --json --data " + data_.path().string()).output);
  EXPECT_EQ(usage["studies"][0]["study"], id);
  EXPECT_EQ(usage["studies"][0]["bytes"], usage["runs"]["bytes"]);
  const CommandResult beginning = ask("delete " + id.substr(0, id.size() - 1));
  EXPECT_EQ(beginning.exit_code, 2);
  EXPECT_THAT(beginning.errors, HasSubstr("give the whole id or the name"));
  EXPECT_EQ(ask("delete " + id).output, id + ": deleted with 2 cases, 0 are kept for other studies\n");
  EXPECT_EQ(ask("show " + id).exit_code, 4);
  EXPECT_THAT(ask("studies").output, Not(HasSubstr(id)));
}

}  // namespace
}  // namespace capstan
