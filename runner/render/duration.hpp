#pragma once
#include <cmath>
#include <string>

#include "solver/case/shown_number.hpp"

namespace capstan {

/// "0.35 s", "12 min", "3.1 h" or "250 h": two digits or whole hours.
inline std::string duration_in_words(double seconds) {
  if (seconds < 90) return rounded(seconds, 2) + " s";
  if (seconds < 90 * 60) return rounded(seconds / 60, 2) + " min";
  const double hours = seconds / 3600;
  return (hours < 99 ? rounded(hours, 2) : std::to_string(std::llround(hours))) + " h";
}

}  // namespace capstan
