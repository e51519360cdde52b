#pragma once
// The product of a study's axes.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "runner/study/axis.hpp"

namespace capstan {

/// Index of the value on each axis at one point of the product. The last axis varies fastest.
using AxisIndices = std::vector<std::size_t>;
AxisIndices axis_indices(const std::vector<Axis>& axes, std::size_t point);

/// Number of points; a double, because it can exceed every integer type.
double product_size(const std::vector<Axis>& axes);

/// The pointer into the study for a pointer into the case at one point: "/Ca" → "/axes/Ca/2" or "/base/Ca".
std::string study_pointer(const std::string& case_pointer, const std::vector<Axis>& axes,
                          const AxisIndices& indices);

/// The first token of a pointer into a case: "/fidelity/dx" → "fidelity".
std::string first_token(const std::string& pointer);

}  // namespace capstan
