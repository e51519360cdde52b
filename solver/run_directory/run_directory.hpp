#pragma once
// The directory of one run: the names of its files (schema/run_directory.md), and the daemon's operations on
// them.
//
// `capstan solve` writes the files; the daemon, `capstan doctor` and the tests read them. All of them take
// the names from here.
#include <array>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace capstan {

class RunDirectory {
 public:
  explicit RunDirectory(std::filesystem::path path) : path_(std::move(path)) {}

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path case_file() const { return path_ / "case.json"; }
  std::filesystem::path history_file() const { return path_ / "history.jsonl"; }
  std::filesystem::path result_file() const { return path_ / "result.json"; }
  std::filesystem::path log_file() const { return path_ / "log"; }
  std::filesystem::path attempt_file() const { return path_ / "attempt"; }
  std::filesystem::path lock_file() const { return path_ / "lock"; }
  /// The two files that a run writes its checkpoints to in turn; the first checkpoint goes to the first one.
  std::array<std::filesystem::path, 2> checkpoint_paths() const;
  std::filesystem::path shapes_directory() const { return path_ / "shapes"; }
  std::filesystem::path shape_index_file() const { return path_ / "shapes.xdmf2"; }
  std::filesystem::path mesh_file() const { return shapes_directory() / "mesh.h5"; }
  /// \param frame  counts from 0; shapes/0007.h5 for 7
  std::filesystem::path frame_file(int frame) const;

  /// The run of the same case at another resolution: rungs/162 for 162 nodes.
  RunDirectory rung(int nodes) const;
  std::filesystem::path rungs_directory() const { return path_ / "rungs"; }

  /// True for the index of the shapes and for all that lies in shapes/, also for files still being written.
  /// Of the run and of its rungs.
  bool is_shape(const std::filesystem::path& file) const;
  /// True for a checkpoint, also for one that is still being written.
  bool is_checkpoint(const std::filesystem::path& file) const;

  /// Makes the directory, and writes the case file unless it holds that document already.
  void prepare(const std::string& case_document) const;

  /// Makes the checkpoints and shapes of another run, and those of its rungs, appear here: this run goes on
  /// from them if it makes the same steps. Leaves files that are here already.
  void go_on_from(const RunDirectory& earlier) const;

  /// Gives the directory to the attempt with this token. Processes of earlier attempts publish nothing any
  /// more (attempt_token.hpp).
  void begin_attempt(const std::string& token) const;
  /// From now on no process publishes anything.
  void withdraw_attempt() const;
  /// Whether the directory belongs to the attempt with this token, or to a repetition of it whose token is
  /// TOKEN.MORE.
  bool is_attempt(const std::string& token) const;

  /// Removes the unfinished files (*.partial) of a killed process. No process may be working in the
  /// directory.
  void remove_partial_files() const;
  bool has_partial_files() const { return !partial_files().empty(); }

  /// True if there is neither a result nor a checkpoint: nothing is lost when the directory is deleted.
  bool is_worthless() const;

  /// The content of result.json; nothing if there is no such file, or if it is not a whole JSON object.
  /// Throws std::filesystem::filesystem_error where the file is there but cannot be read.
  std::optional<nlohmann::ordered_json> result() const;

  /// The last lines of the log, at most `max_size` bytes; a line that is cut is left out.
  std::string log_tail(std::size_t max_size = 2000) const;

 private:
  std::vector<std::filesystem::path> partial_files() const;

  std::filesystem::path path_;
};

}  // namespace capstan
