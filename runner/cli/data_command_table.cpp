// Rows of the commands that work on a data directory.
#include "runner/cli/command_table.hpp"
#include "runner/cli/commands.hpp"
#include "runner/cli/configuration_file.hpp"
#include "runner/cli/options.hpp"

namespace capstan {
namespace {

void slurm_options(CLI::App& parser, ServeArguments& arguments) {
  parser.add_option("--executor", arguments.executor, "where cases are computed: local or slurm")
      ->check(CLI::IsMember({"local", "slurm"}))
      ->capture_default_str();
  parser.add_option("--jobs", arguments.jobs, "jobs of Slurm that wait or run at the same time")
      ->check(CLI::Range(1, 100000))
      ->type_name("N")
      ->capture_default_str();
  parser.add_option("--partition", arguments.partition, "Slurm's partition")->type_name("P");
  parser.add_option("--account", arguments.account, "Slurm's account")->type_name("A");
  parser.add_option("--time", arguments.time, "longest time to ask Slurm for, such as 60 or 1-12:00:00")
      ->type_name("T");
  parser.add_option("--extra", arguments.extra, "further arguments of sbatch, separated by spaces")
      ->type_name("\"ARGUMENTS\"");
}

Command serve_command() {
  return command<ServeArguments>(
      "serve", "run the server: takes studies, computes their cases, answers over HTTP",
      {[](CLI::App& parser, ServeArguments&) { add_configuration_file(parser); },
       [](CLI::App& parser, ServeArguments& arguments) {
         parser.add_option("--data", arguments.data, "where everything is kept; made if it is not there")
             ->type_name("DIR")
             ->capture_default_str();
       },
       [](CLI::App& parser, ServeArguments& arguments) {
         parser
             .add_option("--listen", arguments.listen,
                         "an address of this machine; port 0 takes any free one")
             ->type_name("HOST:PORT")
             ->capture_default_str();
       },
       [](CLI::App& parser, ServeArguments& arguments) {
         parser
             .add_option("--host", arguments.hosts,
                         "a name under which clients ask, besides localhost and addresses")
             ->type_name("NAME");
       },
       options::cores("cases that run side by side"),
       [](CLI::App& parser, ServeArguments& arguments) {
         parser
             .add_option("--memory", arguments.memory_mb, "megabytes that a case may take; without it, all")
             ->check(CLI::PositiveNumber)
             ->type_name("MB");
       },
       [](CLI::App& parser, ServeArguments& arguments) {
         parser
             .add_option("--wall-time", arguments.wall_seconds,
                         "seconds that an attempt may take; without it, any")
             ->check(CLI::PositiveNumber)
             ->type_name("S");
       },
       [](CLI::App& parser, ServeArguments& arguments) {
         parser.add_option("--lease", arguments.lease_seconds, "seconds that a process may stand still")
             ->check(CLI::Range(1, 86400))
             ->type_name("S")
             ->capture_default_str();
       },
       slurm_options},
      "Ctrl-C or SIGTERM: running cases write a checkpoint, and the next start goes on from there.\n"
      "A token in the environment (CAPSTAN_TOKEN, or a file named by CAPSTAN_TOKEN_FILE) is asked of every "
      "client;\n"
      "addresses that other machines can reach need one.\n"
      "Example:\n  capstan serve --data /srv/capsules --cores 4\n"
      "  capstan serve --executor slurm --partition main --jobs 200\n",
      serve);
}

Command doctor_command() {
  return command<UpkeepArguments>(
      "doctor", "check a data directory: the database, the run directories, the disk",
      {options::data,
       [](CLI::App& parser, UpkeepArguments& arguments) {
         parser.add_flag("--repair", arguments.repair,
                         "repair what can be repaired without losing anything; stop the server first");
       },
       options::json},
      "Exit code 0: all is well, repaired, or needs nothing (a note). 1: some errors are left.\n"
      "Example:\n  capstan doctor --data /srv/capsules\n",
      examine_data);
}

Command backup_command() {
  return command<UpkeepArguments>(
      "backup", "copy the database, also of a running server",
      {options::file("the copy; an earlier one is replaced"), options::data, options::json},
      "The server may be running. To go back to the copy, put it into an empty data directory as "
      "capstan.sqlite.\n"
      "Shapes and checkpoints stand in runs/, whose files are only ever replaced whole: copy it with any "
      "tool.\n"
      "Example:\n  capstan backup capsules.sqlite --data /srv/capsules\n",
      back_up);
}

Command disk_command() {
  return command<UpkeepArguments>(
      "disk", "what takes space in a data directory, study by study", {options::data, options::json},
      "The server may be running. A case of two studies counts in both, and once in the sum.\n"
      "Example:\n  capstan disk --data /srv/capsules\n",
      print_disk_usage);
}

Command collect_command() {
  return command<CollectArguments>(
      "collect", "record the results of an exported study (export-cases) in a data directory",
      {[](CLI::App& parser, CollectArguments& arguments) {
         parser.add_option("DIR", arguments.directory, "the exported directory")->required();
       },
       options::data, options::json},
      "Stop the server of the data directory first. Each result is recorded once, however often this is "
      "done.\n"
      "Example:\n  capstan collect fig17-cases --data /srv/capsules\n",
      collect_results);
}

}  // namespace

std::vector<Command> data_commands() {
  return {serve_command(), collect_command(), doctor_command(), backup_command(), disk_command()};
}

}  // namespace capstan
