#pragma once
// Where a membrane without bending stiffness wrinkles.
#include "solver/case/case.hpp"

namespace capstan {

/// A sphere, or a spheroid with semi-axes that differ by less than a quarter.
bool is_nearly_round(const Case& c);

/// Whether the flow compresses the membrane so much that it would wrinkle without bending stiffness. The
/// limits are from runs with boundary integrals to kt = 10, at V = 1, 5 and 20 and Ca = 0.02 to 0.5:
/// - Red cells, and spheroids with b/a = 0.7, 0.5, 0.25, 1.5 and 3, at V = 1 and Ca up to 0.1 or 0.2:
///   neighbouring triangles meet at angles of 70 to 180 degrees from kt = 3 to 8 on. At V = 5 only the
///   flatter shapes wrinkle, at V = 20 none does.
/// - Nearly round shapes wrinkle at V = 1 and Ca = 0.0125 to 0.02, but not at Ca = 0.05.
/// - At larger Ca the ends of the capsule become pointed, and the rest of the membrane stays smooth.
bool is_compressed(const Case& c);

/// The time kt before which no wrinkles were seen.
inline constexpr double kFirstWrinkles = 2;

}  // namespace capstan
