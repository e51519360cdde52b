#pragma once
// The sentences of result.json that explain a label.
#include <string>

#include "solver/observe/classify.hpp"
#include "solver/observe/motion_features.hpp"

namespace capstan {

/// The reason for the motion, or for "undecided".
std::string explanation(Motion motion, const MotionFeatures& features);

/// The same for samples that have no features: the run was too short, or its positions are not finite.
std::string explanation_without_features(Samples samples);

}  // namespace capstan
