#pragma once
// The commands, with their arguments read. Each returns the exit code.
#include <string>
#include <vector>

#include "runner/cli/client.hpp"
#include "runner/daemon/usable_cores.hpp"

namespace capstan {

struct ServeArguments {
  std::string data = "capstan-data";
  std::string listen = "127.0.0.1:8017";
  std::vector<std::string> hosts = {};  ///< names of this server besides its addresses
  double memory_mb = 0;                 ///< that a case may take; 0: as much as it wants
  int wall_seconds = 0;                 ///< that an attempt may take; 0: as long as it wants
  int lease_seconds = 60;               ///< that a process may stand still
  int cores = usable_cores();           ///< cases that run side by side
};
int serve(const ServeArguments& arguments);

struct UpkeepArguments {
  std::string data = "capstan-data";
  bool mend = false;  ///< of examine_data
  std::string file;   ///< of back_up
  bool json = false;
};
int examine_data(const UpkeepArguments& arguments);
int back_up(const UpkeepArguments& arguments);
int print_disk_usage(const UpkeepArguments& arguments);

struct FileArguments {
  std::string file;
  bool json = false;
};
int validate_file(const FileArguments& arguments);

struct SubmitArguments {
  std::string file;
  bool watch = false;
  bool json = false;
  std::string server = kDefaultServer;
};
int submit_study(const SubmitArguments& arguments);

struct StudyArguments {
  std::vector<std::string> ids;  ///< as they were typed: ids, their beginnings, names of studies
  std::string format = "table";  ///< of print_results: table, csv, json
  std::string x, y;              ///< of print_phase_diagram: the axes to draw, or the server's choice
  std::vector<std::string> at;   ///< of print_phase_diagram: AXIS=VALUE where the others are fixed
  bool json = false;
  std::string server = kDefaultServer;
};
int print_studies(const StudyArguments& arguments);  ///< of all studies: without ids
int print_study(const StudyArguments& arguments);
int watch_study(const StudyArguments& arguments);
int print_results(const StudyArguments& arguments);
int print_phase_diagram(const StudyArguments& arguments);
/// \param change  cancel, pause, resume, retry, priority
int change_study(const StudyArguments& arguments, const std::string& change, const std::string& body = "");
int delete_study(const StudyArguments& arguments);
int explain(const StudyArguments& arguments);  ///< studies and cases

}  // namespace capstan
