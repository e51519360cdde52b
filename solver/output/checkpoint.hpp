#pragma once
// Checkpoints of a run: two files, written in turn. If one is damaged, during writing or later, the run
// resumes from the other one.
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "solver/state/state_archive.hpp"

namespace capstan {

enum class Durable {
  yes,  ///< waits for the disk: the file survives a power failure
  no,
};

/// Replaces the older (or unusable) one of checkpoint-a.h5 and checkpoint-b.h5. Each entry of the
/// archive is one array of the HDF5 file, written without a copy in memory. Throws a std::runtime_error
/// naming operation and file; then both old files are unchanged.
void write_checkpoint(const std::filesystem::path& directory, const StateArchive& state,
                      const std::string& steps_id, Durable durable = Durable::yes);

/// The newest checkpoint that is undamaged and belongs to a case with these steps, this numerics version and
/// this format; none if there is no such file. For each file that is not used, `on_passed_over` is called
/// with a sentence that gives the reason.
std::optional<StateArchive> read_newest_checkpoint(
    const std::filesystem::path& directory, const std::string& steps_id,
    const std::function<void(const std::string&)>& on_passed_over = [](const std::string&) {});

}  // namespace capstan
