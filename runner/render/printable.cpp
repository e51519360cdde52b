#include "runner/render/printable.hpp"

#include <cstdint>

namespace capstan {
namespace {

/// Length of the UTF-8 sequence that starts with this byte; 0 if none does.
std::size_t sequence_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// The code point at the start of the text, -1 if the bytes there are invalid.
/// \param length  set to the number of its bytes; 1 for an invalid one
std::int32_t first_code_point(std::string_view text, std::size_t& length) {
  length = sequence_length(static_cast<unsigned char>(text[0]));
  bool is_whole = length > 0 && length <= text.size();
  std::int32_t character = length == 1 ? text[0] : static_cast<unsigned char>(text[0]) & (0x7F >> length);
  for (std::size_t i = 1; is_whole && i < length; ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    is_whole = (byte & 0xC0) == 0x80;
    character = character << 6 | (byte & 0x3F);
  }
  if (!is_whole) length = 1;
  return is_whole ? character : -1;
}

/// \param character  code point, or -1
bool is_safe(std::int32_t character) {
  if (character == '\n' || character == '\t') return true;
  const bool is_control = character < 0x20 || (character >= 0x7F && character < 0xA0);
  const bool reverses =
      (character >= 0x202A && character <= 0x202E) || (character >= 0x2066 && character <= 0x2069);
  return !is_control && !reverses;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string safe;
  for (std::size_t length = 0; !text.empty(); text.remove_prefix(length))
    safe += is_safe(first_code_point(text, length)) ? std::string(text.substr(0, length)) : "?";
  return safe;
}

}  // namespace capstan
