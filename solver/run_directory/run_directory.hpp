#pragma once
// The directory of one run, as the daemon sees it (schema/run_directory.md).
#include <filesystem>
#include <nlohmann/json.hpp>
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
  std::filesystem::path lock_file() const { return path_ / "lock"; }

  /// Makes the directory and the case file, if they are not there yet or damaged.
  void prepare(const std::string& case_document) const;

  /// Takes away what a killed process left half-written. Nobody works in the directory.
  void remove_partial_files() const;
  bool has_partial_files() const { return !partial_files().empty(); }

  /// Neither a result nor a checkpoint: to delete it loses nothing.
  bool is_worthless() const;

  /// result.json, if the run has ended and left one that is whole. Throws std::filesystem::filesystem_error
  /// where it is there but cannot be read.
  std::optional<nlohmann::ordered_json> result() const;

  /// The end of what the process said, at most `size` bytes and from the start of a line.
  std::string log_tail(std::size_t size = 2000) const;

 private:
  std::vector<std::filesystem::path> partial_files() const;

  std::filesystem::path path_;
};

}  // namespace capstan
