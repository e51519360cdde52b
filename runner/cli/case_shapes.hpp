#pragma once
// The recorded shapes of a case, from the server (schema/shapes.md).
#include <functional>
#include <span>
#include <string>

#include "runner/cli/client.hpp"

namespace capstan {

/// A shape while it is visited.
struct VisitedShape {
  double kt;
  std::span<const double> positions;   ///< #V x 3, / a
  std::span<const double> velocities;  ///< #V x 3, / (a k)
  std::span<const int> triangles;      ///< #F x 3, vertices from 0
};

/// Calls `visit` with all shapes in the order of their times. Throws Refused if the case has none.
void for_each_shape(Client& client, const std::string& case_path,
                    const std::function<void(const VisitedShape& shape)>& visit);

}  // namespace capstan
