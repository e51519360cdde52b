#pragma once
// What the commands do once their options are parsed. Each function returns the exit code.
#include <optional>
#include <string>
#include <vector>

#include "runner/cli/client.hpp"
#include "runner/daemon/usable_cores.hpp"

namespace capstan {

struct ServeArguments {
  std::string data = "capstan-data";
  std::string listen = "127.0.0.1:8017";
  std::vector<std::string> hosts = {};  ///< names of this server besides its addresses
  double memory_mb = 0;                 ///< limit of a case; 0: no limit
  int wall_seconds = 0;                 ///< limit of an attempt; 0: no limit
  int lease_seconds = 60;               ///< time after which a process without progress is stopped
  int cores = usable_cores();           ///< number of cases that run side by side
  std::string executor = "local";       ///< local or slurm
  int jobs = 100;                       ///< of Slurm, waiting or running at the same time
  std::string partition, account;       ///< of Slurm; "": its default
  std::string time;                     ///< longest time to ask Slurm for; "": no limit
  std::string extra;                    ///< further arguments of sbatch
};
int serve(const ServeArguments& arguments);

struct UpkeepArguments {
  std::string data = "capstan-data";
  bool repair = false;  ///< for examine_data
  std::string file;     ///< for back_up
  bool json = false;
};
int examine_data(const UpkeepArguments& arguments);
int back_up(const UpkeepArguments& arguments);
int print_disk_usage(const UpkeepArguments& arguments);

struct ExportArguments {
  std::string file;
  std::string directory;
  int jobs = 100;  ///< tasks of the job array, at most
};
int export_study(const ExportArguments& arguments);

struct CollectArguments {
  std::string directory;
  std::string data = "capstan-data";
  bool json = false;
};
int collect_results(const CollectArguments& arguments);

struct FileArguments {
  std::string file;
  bool json = false;
};
int validate_file(const FileArguments& arguments);
int plan_file(const FileArguments& arguments);

struct PresetArguments {
  bool json = false;
};
int print_presets(const PresetArguments& arguments);

struct SubmitArguments {
  std::string file;
  bool watch = false;
  bool json = false;
  std::string server = kDefaultServer;
};
int submit_study_file(const SubmitArguments& arguments);

struct StudyArguments {
  std::vector<std::string> ids;         ///< as typed: ids, beginnings of ids, names of studies
  std::string format = "table";         ///< for print_results: table, csv, json
  std::string x, y;                     ///< for print_phase_diagrams: axes to draw; empty: the server chooses
  std::vector<std::string> at;          ///< for print_phase_diagrams: AXIS=VALUE for axes that are not drawn
  std::optional<std::string> fidelity;  ///< for retry_studies: a preset
  bool json = false;
  std::string server = kDefaultServer;
};
int print_studies(const StudyArguments& arguments);  ///< ignores `ids`
int show_studies(const StudyArguments& arguments);
int watch_studies(const StudyArguments& arguments);
int print_results(const StudyArguments& arguments);
int print_boundaries(const StudyArguments& arguments);
int print_phase_diagrams(const StudyArguments& arguments);
int explain(const StudyArguments& arguments);  ///< `ids` may also name cases

int print_histories(const StudyArguments& arguments);  ///< `ids` name cases

struct FigureArguments {
  std::vector<std::string> ids;        ///< a study, or cases
  std::string out;                     ///< the picture: .svg, .pdf or .png
  std::string kind;                    ///< as --of names it; empty: the one that fits
  std::string x, y;                    ///< of a phase diagram: axes to draw; empty: the server chooses
  std::vector<std::string> at;         ///< AXIS=VALUE for axes that are not drawn
  std::vector<std::string> published;  ///< files of published points to draw beside histories
  std::vector<double> times;           ///< kt of profiles; empty: the last shape
  bool is_wide = false;                ///< two columns of a page
  std::string server = kDefaultServer;
};
int draw_figure(const FigureArguments& arguments);

struct ShapeArguments {
  std::string id;            ///< a case, as typed
  std::string out;           ///< .vtp, .stl or .obj: one shape; .pvd: all of them, for ParaView
  std::optional<double> kt;  ///< the nearest recorded time is taken; nothing: the last one
  std::string server = kDefaultServer;
};
int save_shapes(const ShapeArguments& arguments);

/// \param change  cancel, pause or resume
int change_studies(const StudyArguments& arguments, const std::string& change);
int retry_studies(const StudyArguments& arguments);
/// \param arguments  the last of `ids` is the priority
int set_priority(const StudyArguments& arguments);
int delete_studies(const StudyArguments& arguments);

}  // namespace capstan
