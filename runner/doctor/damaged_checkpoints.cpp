#include "runner/doctor/damaged_checkpoints.hpp"

#include "solver/case/content_id.hpp"
#include "solver/run_directory/checkpoint_files.hpp"

namespace capstan {

std::vector<DamagedCheckpoint> damaged_checkpoints(const std::filesystem::path& runs, Database& database) {
  std::vector<DamagedCheckpoint> damaged;
  Statement row =
      database.query("SELECT id, steps_id FROM cases WHERE state IN ('queued', 'failed', 'cancelled')");
  while (row.step()) {
    auto [newer, older] = checkpoint_files(RunDirectory(runs / row.text(0)), row.text(1), kNumericsVersion);
    newer = with_checksum(newer);
    older = with_checksum(older);
    const std::filesystem::path usable = newer.usable() ? newer.path : older.usable() ? older.path : "";
    for (const CheckpointFile& file : {newer, older})
      if (file.is_damaged) damaged.push_back({file.path, file.reason, usable});
  }
  return damaged;
}

}  // namespace capstan
