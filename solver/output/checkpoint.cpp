#include "solver/output/checkpoint.hpp"

#include <stdexcept>

#include "solver/case/content_id.hpp"
#include "solver/run_directory/checkpoint_files.hpp"
#include "solver/run_directory/durable_file.hpp"
#include "solver/run_directory/hdf5_file.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

StateArchive read_state(const CheckpointFile& checkpoint) {
  const std::string reason = with_checksum(checkpoint).reason;
  if (!reason.empty()) throw std::runtime_error(checkpoint.path.string() + " " + reason);
  const Hdf5Reader file(checkpoint.path);
  StateArchive state;
  for (const std::string& name : file.names()) state.put(name, file.read(name));
  return state;
}

}  // namespace

void write_checkpoint(const fs::path& directory, const StateArchive& state, const std::string& steps_id,
                      Durable durable) {
  const auto [newer, older] = checkpoint_files(RunDirectory(directory), steps_id, kNumericsVersion);
  PendingFile pending(older.path);
  Hdf5Writer file(pending.temporary(), kCheckpointHeaderSize);
  for (const std::string& name : state.names()) file.write(name, state.get(name));
  file.close();
  seal_checkpoint(
      pending.temporary(),
      {.numerics = kNumericsVersion, .steps_id = steps_id, .sequence = newer.header.sequence + 1});
  durable == Durable::yes ? pending.publish() : pending.replace();
}

std::optional<StateArchive> read_newest_checkpoint(
    const fs::path& directory, const std::string& steps_id,
    const std::function<void(const std::string&)>& on_passed_over) {
  const auto both = checkpoint_files(RunDirectory(directory), steps_id, kNumericsVersion);
  for (const CheckpointFile& file : both)
    if (!file.reason.empty()) on_passed_over(file.path.string() + " " + file.reason);
  for (const CheckpointFile& file : both) {
    if (!file.usable()) continue;
    try {
      return read_state(file);
    } catch (const std::runtime_error& error) {
      on_passed_over(error.what());
    }
  }
  return std::nullopt;
}

}  // namespace capstan
