#pragma once
// Where a membrane without bending stiffness wrinkles.
#include "solver/case/case.hpp"

namespace capstan {

/// A sphere, or a spheroid with semi-axes that differ by less than a quarter.
bool is_nearly_round(const Case& c);

/// Whether the flow compresses the membrane so that it would wrinkle without bending stiffness. Measured to
/// kt = 10, V = 1, 5 and 20, Ca = 0.02 to 0.5, with boundary integrals: at V = 1 red cells and spheroids of
/// b/a = 0.7, 0.5, 0.25, 1.5 and 3 fold by 70 to 180 degrees from kt = 3 to 8 on where Ca is at most 0.1 to
/// 0.2, at V = 5 the flatter ones, at V = 20 none. Nearly round shapes do at Ca = 0.0125 to 0.02 and V = 1,
/// not at 0.05. Larger Ca draw the capsule out to sharp tips, and its middle stays smooth.
bool is_compressed(const Case& c);
inline constexpr double kFirstWrinkles = 2;  ///< kt: none are seen before

}  // namespace capstan
