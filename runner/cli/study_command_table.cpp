// Rows of the commands that read a study file or ask a server about studies.
#include "runner/cli/command_table.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/options.hpp"

namespace capstan {
namespace {

using Studies = StudyArguments;

/// --x, --y and --at: which section of the study is drawn.
template <class Arguments>
void add_section(CLI::App& parser, Arguments& arguments) {
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

Command export_command() {
  return command<ExportArguments>(
      "export-cases", "write a study as files for a cluster on which no server may run",
      {[](CLI::App& parser, ExportArguments& arguments) {
        parser.add_option("FILE", arguments.file, "the study; - is standard input")->required();
        parser
            .add_option("DIR", arguments.directory, "made if it is not there; may be copied to the cluster")
            ->required();
        parser.add_option("--jobs", arguments.jobs, "tasks of the job array, at most")
            ->check(CLI::Range(1, 1000))
            ->type_name("N")
            ->capture_default_str();
      }},
      "There: cd DIR && sbatch job.sh, again if some cases have no result. Then: capstan collect DIR.\n"
      "Example:\n  capstan export-cases studies/fig17/study.json fig17-cases\n",
      export_study);
}

Command validate_command() {
  return command<FileArguments>(
      "validate", "check the file of a study or a case; every issue is reported",
      {options::file("the study or case; - is standard input"), options::json},
      "All issues are reported at once, each with its place in the file. Nothing is computed.\n"
      "Example:\n  capstan validate studies/quickstart/study.json\n",
      validate_file);
}

Command plan_command() {
  return command<FileArguments>(
      "plan", "what a study or a case will model, leave out and cost, before it is computed",
      {options::file("the study or case; - is standard input"), options::json},
      "Says what is modelled, what is left out and what that changes, the flow model and why it was chosen, "
      "the expected\nerror, time, memory and disk, and warns of settings that make the answer doubtful. "
      "Cases of "
      "a study whose plans have\nthe same words are one group. Nothing is computed; capstan estimate "
      "measures the "
      "time on this machine.\n"
      "Example:\n  capstan plan studies/fig17/study.json\n",
      plan_file);
}

Command fidelity_command() {
  return command<PresetArguments>(
      "fidelity", "the presets of accuracy against speed, with measured cost and error", {options::json},
      "A case or the base of a study names one, \"fidelity\": \"standard\", or changes settings of it:\n"
      "\"fidelity\": {\"preset\": \"standard\", \"nodes\": 642}. With boundary integrals a preset sets the "
      "nodes alone.\n"
      "Example:\n  capstan fidelity\n",
      print_presets);
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
      submit_study_file);
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
  return command<Studies>(
      "retry", "queue the failed cases of a study again, at a finer setting if asked",
      {options::study_ids,
       [](CLI::App& parser, Studies& arguments) {
         parser
             .add_option("--fidelity", arguments.fidelity,
                         "compute the failed and diverged cases at this one, as fine or '{\"error\": 0.01}'")
             ->type_name("FIDELITY");
       },
       options::json, options::server},
      "Example:\n  capstan retry quickstart-3f9c --fidelity fine\n", retry_studies);
}

void add_picture(CLI::App& parser, FigureArguments& arguments) {
  parser
      .add_option("ID", arguments.ids,
                  "a study, or one case or several: ids, beginnings of ids, a study's name")
      ->required();
  parser
      .add_option(
          "--of", arguments.kind,
          "phase-diagram; history: D_xy and theta over time; path: of Q = D_xy (cos 2 theta, sin 2 "
          "theta); profile: the section of the membrane with the plane of shear; trajectory: of a point "
          "of the membrane; by default the first for a study with two axes, else the second")
      ->check(CLI::IsMember({"phase-diagram", "history", "path", "profile", "trajectory"}));
  parser
      .add_option(
          "--kt", arguments.times,
          "the time of a profile, or several separated by commas: a panel each; by default the last shape")
      ->type_name("T")
      ->delimiter(',');
  parser
      .add_option(
          "--published", arguments.published,
          "CSV of published points to draw beside histories, once a file; columns: kt, D_xy, theta (in "
          "units of pi), paper, and parameters such as Ca, of which only the values of the cases are drawn. "
          "In a phase diagram: points of a boundary, columns: its two axes, paper")
      ->type_name("FILE")
      ->allow_extra_args(false);
  parser.add_flag("--wide", arguments.is_wide,
                  "17.5 cm for two columns of a page, instead of 8.5 cm for one");
}

Command figure_command() {
  return command<FigureArguments>(
      "figure", "draw a study or cases: phase diagram, histories, path of Q, profiles or trajectories",
      {add_picture, options::output_file("the picture: FILE.svg, .pdf or .png"), add_section<FigureArguments>,
       options::server},
      "The picture is drawn by gnuplot; its script with all data stays beside it, as FILE.gp. In a phase "
      "diagram open "
      "marks\nare not confirmed. A path of Q around 0 is tumbling, one that leaves 0 aside tank-treading. "
      "The dot "
      "of a profile and\nthe point of a trajectory are the same material point of the membrane, at the start "
      "at "
      "the tip of the major axis.\n"
      "Example:\n  capstan figure fig17 -o fig17.pdf\n  capstan figure fig16a -o path.svg --of path\n"
      "  capstan figure fig14 -o fig14.svg --of profile --kt 5,8,11\n",
      draw_figure);
}

Command boundary_command() {
  return command<Studies>(
      "boundary", "where tumbling ends and tank-treading begins, of a study that seeks it",
      {options::study_ids, add_format, options::server},
      "A study with \"boundary\" instead of axes looks for it: {\"along\": \"Ca\", \"between\": [0.05, 1], "
      "\"for\": {\"V\": [1, 2, 4]}}.\nlow and high: limits with the errors of the cases; band: where the "
      "motion "
      "is a transition.\n"
      "Example:\n  capstan boundary fig17_boundary\n",
      print_boundaries);
}

Command history_command() {
  return command<Studies>("history",
                          "the history of a case as CSV: D_xy, theta and the other quantities over time",
                          {add_ids_of_studies_and_cases, options::json, options::server},
                          "Several cases are one table, whose first columns are the cases and the parameters "
                          "in which they differ. Of all cases of a study: GET /v1/studies/{id}/histories.\n"
                          "Example:\n  capstan history 123c62c4 > history.csv\n",
                          print_histories);
}

void add_shape(CLI::App& parser, ShapeArguments& arguments) {
  parser.add_option("CASE", arguments.id, "the case: its id, or a beginning that no other id has")
      ->required();
  parser
      .add_option("--kt", arguments.kt,
                  "the time; the shape recorded nearest to it is taken, by default the last")
      ->type_name("T");
}

Command shape_command() {
  return command<ShapeArguments>(
      "shape", "save a shape of a case as VTK, STL or OBJ, or all of them for ParaView",
      {add_shape, options::output_file("FILE.vtp, .stl or .obj: one shape; FILE.pvd: all, for ParaView"),
       options::server},
      "A .vtp file holds the velocity, the force and the stretch at each vertex, too. FILE.pvd is the index "
      "of "
      "files\nFILE_0000.vtp, FILE_0001.vtp .., one a time. Cases record shapes each outputs.shapes_every.\n"
      "Example:\n  capstan shape 123c62c4 --kt 12 -o cell.vtp\n  capstan shape 123c62c4 -o cell.pvd\n",
      save_shapes);
}

}  // namespace

std::vector<Command> study_commands() {
  using namespace options;
  return {
      validate_command(),
      export_command(),
      plan_command(),
      fidelity_command(),
      submit_command(),
      command<Studies>("studies", "list all studies, the newest first", {json, server},
                       "A study is queued, running, paused, done (all its cases have ended) or cancelled.\n"
                       "Example:\n  capstan studies\n",
                       print_studies),
      command<Studies>("show", "one study: its axes, progress and motions", {study_ids, json, server},
                       "Example:\n  capstan show quickstart-3f9c\n", show_studies),
      watch_command(),
      command<Studies>(
          "results", "the cases of a study and what came of them", {study_ids, add_format, server},
          "Example:\n  capstan results quickstart-3f9c --format csv > quickstart.csv\n", print_results),
      command<Studies>("phase-diagram", "the motion over two axes of a study",
                       {study_ids, add_section<Studies>, json, server},
                       "In colours on a terminal, unless the environment has NO_COLOR.\n"
                       "Example:\n  capstan phase-diagram quickstart-3f9c\n"
                       "  capstan phase-diagram sweep-81cc --x Ca --y V --at E_b=0.015\n",
                       print_phase_diagrams),
      boundary_command(),
      figure_command(),
      history_command(),
      shape_command(),
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
