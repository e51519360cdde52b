#pragma once
// A study in words.
#include <cstddef>
#include <string>
#include <vector>

namespace capstan {

/// "4 cases"; where several points are one case "6 points, 2 cases".
std::string size_text(std::size_t points, std::size_t cases);

/// One line a note.
std::string notes_text(const std::vector<std::string>& notes);

}  // namespace capstan
