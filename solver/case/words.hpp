#pragma once
// The values of an enumeration and the words for them in files, in the database and in answers: each pair is
// defined once, in the table kWords next to the enumeration.
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace capstan {

template <class Enum>
struct Word {
  Enum value;
  std::string_view word;
};

/// Specialised by each enumeration that has words: a std::array of Word<Enum>; of a parameter, the default
/// first.
template <class Enum>
inline constexpr bool kWords = false;

template <class Enum>
concept HasWords = requires {
  kWords<Enum>.size();
};

/// The word for a value, e.g. "biconcave".
template <HasWords Enum>
constexpr std::string_view to_string(Enum value) {
  for (const auto& row : kWords<Enum>)
    if (row.value == value) return row.word;
  return "";
}

/// The value of a word; nothing for a word that is not in the table.
template <HasWords Enum>
constexpr std::optional<Enum> parse_word(std::string_view word) {
  for (const auto& row : kWords<Enum>)
    if (row.word == word) return row.value;
  return std::nullopt;
}

/// All words, in the order of the table.
template <HasWords Enum>
constexpr auto words_of() {
  std::array<std::string_view, kWords<Enum>.size()> words;
  for (std::size_t row = 0; row < words.size(); ++row) words[row] = kWords<Enum>[row].word;
  return words;
}

}  // namespace capstan
