#pragma once
// The first 512 bytes of a checkpoint: the program version that wrote it, the run, its number in the
// sequence, and the checksum of the file.
//
// They are plain text in HDF5's user block (`head -n 6 checkpoint-a.h5` shows them). A damaged file is
// recognised by them before the HDF5 library parses it, because the library crashes on some damaged files.
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace capstan {

inline constexpr int kCheckpointFormat = 2;
inline constexpr size_t kCheckpointHeaderSize = 512;  // the smallest user block HDF5 allows

struct CheckpointHeader {
  int format = kCheckpointFormat;
  int numerics = 0;            ///< kNumericsVersion of the program that wrote the file
  std::string steps_id;        ///< of the case (solver/case/equal_steps.hpp)
  std::uint64_t sequence = 0;  ///< 1 for the first checkpoint of a run; the highest is the newest
  std::uint64_t size = 0;      ///< bytes of the whole file
  /// CRC-32 (zlib's) of the fields above as printed, followed by all bytes after the header
  std::uint32_t crc = 0;
};

/// Writes the header, completed by size and checksum, into a checkpoint that has been closed.
void seal_checkpoint(const std::filesystem::path& path, CheckpointHeader header);

/// The header; nothing if it is not well-formed or gives another size than the file's. Reads only the header.
std::optional<CheckpointHeader> read_checkpoint_header(const std::filesystem::path& path);

/// True if the file has the checksum that its header gives. Reads the whole file.
bool checksum_holds(const std::filesystem::path& path, const CheckpointHeader& header);

}  // namespace capstan
