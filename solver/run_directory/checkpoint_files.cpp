#include "solver/run_directory/checkpoint_files.hpp"

#include <algorithm>
#include <optional>

namespace capstan {
namespace {

namespace fs = std::filesystem;

/// Why an undamaged file cannot be resumed from by this program; "" if it can.
std::string mismatch(const CheckpointHeader& header, const std::string& steps_id, int numerics) {
  if (header.format != kCheckpointFormat) return "has format " + std::to_string(header.format);
  if (header.steps_id != steps_id) return "belongs to a case with other steps, " + header.steps_id;
  if (header.numerics != numerics) return "is of numerics version " + std::to_string(header.numerics);
  return "";
}

CheckpointFile inspect(const fs::path& path, const std::string& steps_id, int numerics) {
  if (!fs::exists(path)) return {.path = path};
  const auto header = read_checkpoint_header(path);
  if (!header) return {.path = path, .reason = "is truncated or has no valid header", .is_damaged = true};
  const std::string reason = mismatch(*header, steps_id, numerics);
  return {.path = path, .header = reason.empty() ? *header : CheckpointHeader{}, .reason = reason};
}

}  // namespace

std::array<CheckpointFile, 2> checkpoint_files(const RunDirectory& directory, const std::string& steps_id,
                                               int numerics) {
  const auto [a, b] = directory.checkpoint_paths();
  std::array<CheckpointFile, 2> both = {inspect(a, steps_id, numerics), inspect(b, steps_id, numerics)};
  if (both[0].header.sequence <= both[1].header.sequence) std::swap(both[0], both[1]);
  return both;
}

void keep_newest_checkpoint(const RunDirectory& directory, const std::string& steps_id, int numerics) {
  std::error_code ignored;
  std::filesystem::remove(checkpoint_files(directory, steps_id, numerics)[1].path, ignored);
}

CheckpointFile with_checksum(CheckpointFile file) {
  if (!file.usable() || checksum_holds(file.path, file.header)) return file;
  return {.path = file.path, .reason = "fails its checksum", .is_damaged = true};
}

}  // namespace capstan
