#include "runner/cli/command_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Every command of the tables, those below `capstan bench` with their full name.
std::vector<Command> all_commands() {
  WorkerCommands worker;
  worker.benchmarks = {{"kernel", "a benchmark", "a second", [](std::ostream&, bool) {}}};
  std::vector<Command> all;
  for (const auto& table : {data_commands(), study_commands(), worker_commands(worker)})
    for (const Command& command : table) {
      if (command.declare) all.push_back(command);
      for (const Command& subcommand : command.subcommands) all.push_back(subcommand);
    }
  return all;
}

/// The command lines below "Example:", without the program's name and without redirections of the shell.
std::vector<std::string> examples_in(const std::string& footer) {
  std::vector<std::string> examples;
  std::istringstream lines(footer.substr(std::min(footer.find("Example:"), footer.size())));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  capstan ")) examples.push_back(line.substr(10, line.find(" >") - 10));
  return examples;
}

TEST(CommandTable, NamesAreUnique) {
  std::set<std::string> names;
  for (const Command& command : all_commands())
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
}

TEST(CommandTable, EverySummaryIsOneLine) {
  for (const Command& command : all_commands()) {
    EXPECT_THAT(command.summary, Not(IsEmpty())) << command.name;
    EXPECT_THAT(command.summary, Not(HasSubstr("\n"))) << command.name;
  }
}

TEST(CommandTable, EveryCommandHasExamplesThatItsParserAccepts) {
  for (const Command& command : all_commands()) {
    CLI::App parser;
    const auto run = command.declare(parser);  // owns the arguments
    const std::vector<std::string> examples = examples_in(parser.get_footer());
    EXPECT_THAT(examples, Not(IsEmpty())) << command.name;
    for (const std::string& example : examples) {
      const std::size_t name = example.find(command.name);
      ASSERT_NE(name, std::string::npos) << example;
      EXPECT_NO_THROW(parser.parse(example.substr(name + command.name.size()))) << example;
    }
  }
}

}  // namespace
}  // namespace capstan
