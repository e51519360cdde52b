// Rows of the commands that read a study file or ask a server about studies.
#include "runner/cli/command_table.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/options.hpp"

namespace capstan {
namespace {

using Studies = StudyArguments;

/// --x, --y and --at: which section of the study `phase-diagram` draws.
void add_section(CLI::App& parser, Studies& arguments) {
  parser.add_option("--x", arguments.x, "the axis to draw across; by default the first")->type_name("AXIS");
  parser.add_option("--y", arguments.y, "the axis to draw upwards; by default the next")->type_name("AXIS");
  parser.add_option("--at", arguments.at, "the value at which another axis is fixed, once an axis")
      ->type_name("AXIS=VALUE")
      ->allow_extra_args(false);
}

void add_format(CLI::App& parser, Studies& arguments) {
  auto* format = parser
                     .add_option("--format", arguments.format,
                                 "table: what varies, what came of it; csv, json: everything")
                     ->check(CLI::IsMember({"table", "csv", "json"}))
                     ->capture_default_str();
  parser.add_flag("--json", arguments.json, "the same as --format json")->excludes(format);
}

void add_ids_and_priority(CLI::App& parser, Studies& arguments) {
  parser
      .add_option("ID", arguments.ids,
                  "the study, or several: its id, a beginning that no other id has, or its name; then the "
                  "priority N from -100 to 100, 0 at first")
      ->type_name("N")
      ->required();
}

void add_ids_of_studies_and_cases(CLI::App& parser, Studies& arguments) {
  parser
      .add_option(
          "ID", arguments.ids,
          "the study or case, or several: its id, a beginning that no other id has, or a study's name")
      ->required();
}

/// cancel, pause or resume.
Command change_command(const std::string& name, const std::string& summary) {
  return command<Studies>(name, summary, {options::study_ids, options::json, options::server},
                          "Example:\n  capstan " + name + " quickstart-3f9c\n",
                          [name](const Studies& arguments) { return change_studies(arguments, name); });
}

Command validate_command() {
  return command<FileArguments>(
      "validate", "check the file of a study or a case; every issue is reported",
      {options::file("the study or case; - is standard input"), options::json},
      "All issues are reported at once, each with its place in the file. Nothing is computed.\n"
      "Example:\n  capstan validate studies/quickstart/study.json\n",
      validate_file);
}

Command submit_command() {
  return command<SubmitArguments>(
      "submit", "hand a study to the server",
      {options::file("the study; - is standard input"),
       [](CLI::App& parser, SubmitArguments& arguments) {
         parser.add_flag("--watch", arguments.watch, "show the progress until all cases have ended");
       },
       options::json, options::server},
      "Prints the study's id. The same study again is the same id, and nothing is computed twice.\n"
      "Example:\n  capstan submit studies/quickstart/study.json --watch\n",
      submit_study);
}

Command watch_command() {
  return command<Studies>("watch", "show the progress of a study until all its cases have ended",
                          {options::study_ids,
                           [](CLI::App& parser, Studies& arguments) {
                             parser.add_flag(
                                 "--json", arguments.json,
                                 "print the study as JSON at the end; the progress goes to standard error");
                           },
                           options::server},
                          "Several studies are watched one after another.\n"
                          "Exit code 0: all cases are done. 3: some have no answer.\n"
                          "Example:\n  capstan watch quickstart-3f9c\n",
                          watch_studies);
}

Command retry_command() {
  return command<Studies>("retry", "queue the failed cases of a study again, at a finer setting if asked",
                          {options::study_ids,
                           [](CLI::App& parser, Studies& arguments) {
                             parser
                                 .add_option("--fidelity", arguments.fidelity,
                                             "compute the failed and diverged cases at this one, as \"fine\"")
                                 ->type_name("PRESET");
                           },
                           options::json, options::server},
                          "Example:\n  capstan retry quickstart-3f9c --fidelity fine\n", retry_studies);
}

}  // namespace

std::vector<Command> study_commands() {
  using namespace options;
  return {
      validate_command(),
      submit_command(),
      command<Studies>("studies", "list all studies, the newest first", {json, server},
                       "A study is queued, running, paused, done (all its cases have ended) or cancelled.\n"
                       "Example:\n  capstan studies\n",
                       list_studies),
      command<Studies>("show", "one study: its axes, progress and motions", {study_ids, json, server},
                       "Example:\n  capstan show quickstart-3f9c\n", show_studies),
      watch_command(),
      command<Studies>(
          "results", "the cases of a study and what came of them", {study_ids, add_format, server},
          "Example:\n  capstan results quickstart-3f9c --format csv > quickstart.csv\n", print_results),
      command<Studies>("phase-diagram", "the motion over two axes of a study",
                       {study_ids, add_section, json, server},
                       "In colours on a terminal, unless the environment has NO_COLOR.\n"
                       "Example:\n  capstan phase-diagram quickstart-3f9c\n"
                       "  capstan phase-diagram sweep-81cc --x Ca --y V --at E_b=0.015\n",
                       print_phase_diagrams),
      change_command("cancel", "take back what a study has not computed yet"),
      command<Studies>(
          "delete", "delete a study and the results that no other study has", {study_ids, json, server},
          "Results, histories and shapes of its cases are deleted, too, unless another study has the same "
          "case; "
          "cases "
          "that\nrun are stopped. To have them back, they must be computed again. Give the whole id or the "
          "study's name.\n"
          "Example:\n  capstan delete quickstart-3f9c\n",
          delete_studies),
      change_command("pause", "start no more cases of a study; what runs goes on"),
      change_command("resume", "start cases of a paused study again"),
      retry_command(),
      command<Studies>("priority", "the studies of the highest number come first, equals take turns",
                       {add_ids_and_priority, json, server},
                       "Example:\n  capstan priority quickstart-3f9c 10\n", set_priority),
      command<Studies>("why", "what a case or the cases of a study wait for, or why they are where they are",
                       {add_ids_of_studies_and_cases, json, server},
                       "Of a study: how many of its cases wait, run or have ended, and for which reasons.\n"
                       "Example:\n  capstan why quickstart-3f9c\n",
                       explain),
  };
}

}  // namespace capstan
