#pragma once
// The product of a study's axes.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/study/axis.hpp"

namespace capstan {

/// One point of the product: which value of each axis, the last axis varying fastest.
using AxisIndices = std::vector<std::size_t>;
AxisIndices axis_indices(const std::vector<Axis>& axes, std::size_t point);

/// Number of points; a double, since nothing has bounded it yet.
double product_size(const std::vector<Axis>& axes);

/// Where a fault of a case at one point stands in the study: case pointer "/Ca" → "/axes/Ca/2" or "/base/Ca".
std::string study_pointer(const std::string& case_pointer, const std::vector<Axis>& axes,
                          const AxisIndices& indices);

/// The first token of a pointer into a case: "/fidelity/dx" → "fidelity".
std::string first_token(const std::string& pointer);

}  // namespace capstan
