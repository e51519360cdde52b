#include "solver/run_directory/checkpoint_header.hpp"

#include <zlib.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace capstan {
namespace {

/// Every field but the checksum. A checkpoint of format 1 has the id of its case.
std::string print_fields(const CheckpointHeader& header) {
  std::ostringstream text;
  text << "capstan-checkpoint " << header.format << "\nnumerics " << header.numerics << "\n"
       << (header.format == 1 ? "case " : "steps ") << header.steps_id << "\nsequence " << header.sequence
       << "\nsize " << header.size << "\n";
  return text.str();
}

std::string print_header(const CheckpointHeader& header) {
  std::string text = print_fields(header) + "crc32 " + std::to_string(header.crc) + "\n";
  if (text.size() > kCheckpointHeaderSize)
    throw std::invalid_argument("the id is too long: " + header.steps_id);
  text.resize(kCheckpointHeaderSize, '\0');
  return text;
}

/// The inverse of print_header. Any other text gives a header that prints differently.
CheckpointHeader scan_header(const std::string& text) {
  CheckpointHeader header;
  std::istringstream in(text);
  std::string label;
  in >> label >> header.format >> label >> header.numerics >> label >> header.steps_id >> label >>
      header.sequence >> label >> header.size >> label >> header.crc;
  return header;
}

/// CRC-32 of the fields, followed by the file after its header; 4 GB/s in zlib 1.2.13.
std::uint32_t compute_crc(const std::filesystem::path& path, const CheckpointHeader& header) {
  const auto extend = [](uLong crc, const char* bytes, size_t count) {
    return crc32_z(crc, reinterpret_cast<const Bytef*>(bytes), count);
  };
  const std::string fields = print_fields(header);
  uLong crc = extend(0, fields.data(), fields.size());
  std::ifstream in(path, std::ios::binary);
  in.seekg(kCheckpointHeaderSize);
  std::vector<char> block(size_t{1} << 18);  // fits into the second-level cache
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    crc = extend(crc, block.data(), static_cast<size_t>(in.gcount()));
  }
  if (in.bad()) throw std::runtime_error("cannot read " + path.string());
  return static_cast<std::uint32_t>(crc);
}

}  // namespace

void seal_checkpoint(const std::filesystem::path& path, CheckpointHeader header) {
  header.size = std::filesystem::file_size(path);
  header.crc = compute_crc(path, header);
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  file << print_header(header) << std::flush;
  if (!file) throw std::runtime_error("cannot write the header of " + path.string());
}

std::optional<CheckpointHeader> read_checkpoint_header(const std::filesystem::path& path) {
  std::string text(kCheckpointHeaderSize, '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(text.data(), kCheckpointHeaderSize)) return std::nullopt;
  const CheckpointHeader header = scan_header(text);
  std::error_code ignored;
  const bool intact =
      text == print_header(header) && header.size == std::filesystem::file_size(path, ignored);
  return intact ? std::optional(header) : std::nullopt;
}

bool checksum_holds(const std::filesystem::path& path, const CheckpointHeader& header) {
  return compute_crc(path, header) == header.crc;
}

}  // namespace capstan
