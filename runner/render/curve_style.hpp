#pragma once
// How the curves of a picture are told apart.
#include <array>
#include <cstddef>
#include <string>

namespace capstan {

/// Okabe and Ito's palette without its yellow.
inline constexpr std::array kCurveColours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                             "#E69F00", "#56B4E9", "#000000"};

inline std::string curve_colour(std::size_t curve) {
  return std::string("lc rgb '") + kCurveColours[curve % kCurveColours.size()] + "'";
}

/// Colour and dashes: solid curves first, then dashed ones in the same colours.
inline std::string curve_style(std::size_t curve) {
  return "lw 1.4 dt " + std::to_string(curve / kCurveColours.size() % 4 + 1) + " " + curve_colour(curve);
}

}  // namespace capstan
