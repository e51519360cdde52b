#pragma once
// The strain law and the constants of all laws as parameters of a case, made from the table of strain laws.
#include <vector>

#include "solver/case/parameters.hpp"

namespace capstan {

/// "law": the name of a strain law.
Parameter strain_law_parameter();

/// One parameter for each key of a constant of some law. It has an effect with the laws that have the
/// constant.
std::vector<Parameter> law_constant_parameters();

}  // namespace capstan
