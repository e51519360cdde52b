#include "solver/simulation/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "solver/case/content_id.hpp"
#include "solver/simulation/checkpoint_header.hpp"
#include "solver/simulation/hdf5_file.hpp"
#include "solver/state/durable_file.hpp"

namespace capstan {
namespace {

namespace fs = std::filesystem;

/// One of the two files, judged by its header alone.
struct Slot {
  fs::path path;
  CheckpointHeader header;  ///< sequence 0 when there is nothing usable
  std::string fault;        ///< why it is not usable; empty when it is, or when there is no file
  bool usable() const { return header.sequence > 0; }
};

std::string fault_of(const std::optional<CheckpointHeader>& header, const std::string& case_id) {
  if (!header) return "is truncated or has no valid header";
  if (header->format != kCheckpointFormat) return "has format " + std::to_string(header->format);
  if (header->case_id != case_id) return "belongs to case " + header->case_id;
  if (header->numerics != kNumericsVersion)
    return "is of numerics version " + std::to_string(header->numerics);
  return "";
}

Slot inspect(const fs::path& path, const std::string& case_id) {
  if (!fs::exists(path)) return {path, {}, ""};
  const auto header = read_checkpoint_header(path);
  const std::string fault = fault_of(header, case_id);
  return {path, fault.empty() ? *header : CheckpointHeader{}, fault};
}

/// Both files, the newer one first; of two unusable ones b, so that a run begins with a.
std::array<Slot, 2> slots(const fs::path& directory, const std::string& case_id) {
  std::array<Slot, 2> both = {inspect(directory / "checkpoint-a.h5", case_id),
                              inspect(directory / "checkpoint-b.h5", case_id)};
  if (both[0].header.sequence <= both[1].header.sequence) std::swap(both[0], both[1]);
  return both;
}

StateArchive read_state(const Slot& slot) {
  if (!checksum_holds(slot.path, slot.header))
    throw std::runtime_error(slot.path.string() + " fails its checksum");
  const Hdf5Reader file(slot.path);
  StateArchive state;
  for (const std::string& name : file.names()) state.put(name, file.read(name));
  return state;
}

}  // namespace

void write_checkpoint(const fs::path& directory, const StateArchive& state, const std::string& case_id) {
  const auto [newer, older] = slots(directory, case_id);
  PendingFile pending(older.path);
  Hdf5Writer file(pending.temporary(), kCheckpointHeaderSize);
  for (const std::string& name : state.names()) file.write(name, state.get(name));
  file.close();
  seal_checkpoint(pending.temporary(),
                  {.numerics = kNumericsVersion, .case_id = case_id, .sequence = newer.header.sequence + 1});
  pending.publish();
}

std::optional<StateArchive> read_newest_checkpoint(
    const fs::path& directory, const std::string& case_id,
    const std::function<void(const std::string&)>& on_passed_over) {
  const auto both = slots(directory, case_id);
  for (const Slot& slot : both)
    if (!slot.fault.empty()) on_passed_over(slot.path.string() + " " + slot.fault);
  for (const Slot& slot : both) {
    if (!slot.usable()) continue;
    try {
      return read_state(slot);
    } catch (const std::runtime_error& error) {
      on_passed_over(error.what());
    }
  }
  return std::nullopt;
}

}  // namespace capstan
