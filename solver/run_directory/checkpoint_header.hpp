#pragma once
// The first 512 bytes of a checkpoint: who wrote it, when in the run, and the checksum of everything.
//
// They are plain text in HDF5's user block (try `head -n 6 checkpoint-a.h5`), so that a damaged file is
// recognised before HDF5 parses a byte of it: its library does not survive every wrong byte.
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace capstan {

inline constexpr int kCheckpointFormat = 1;
inline constexpr size_t kCheckpointHeaderSize = 512;  // the smallest user block HDF5 allows

struct CheckpointHeader {
  int format = kCheckpointFormat;
  int numerics = 0;            ///< kNumericsVersion of the writer
  std::string case_id;         ///< without white space
  std::uint64_t sequence = 0;  ///< 1 for the first checkpoint of a run; the highest is the newest
  std::uint64_t size = 0;      ///< bytes of the whole file
  std::uint32_t crc =
      0;  ///< CRC-32 (zlib's) of the fields above as printed, then of all bytes after the header
};

/// Fills in size and checksum of a closed checkpoint and writes the header into it.
void seal_checkpoint(const std::filesystem::path& path, CheckpointHeader header);

/// The header, if the file has a well-formed one and the size that stands there. Reads no more than the
/// header.
std::optional<CheckpointHeader> read_checkpoint_header(const std::filesystem::path& path);

/// Reads the whole file: does it have the checksum its header says?
bool checksum_holds(const std::filesystem::path& path, const CheckpointHeader& header);

}  // namespace capstan
