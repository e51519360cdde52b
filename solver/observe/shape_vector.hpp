#pragma once
// Q = D (cos 2 theta, sin 2 theta): deformation and angle in one, without a branch where the section is
// round. Samples are never empty here.
#include <Eigen/Core>

#include "solver/observe/motion_sample.hpp"

namespace capstan {

Eigen::Vector2d shape_vector(const MotionSample& sample);

/// Of the segments between successive Q: the curve may pass through 0 between two samples.
double smallest_distance_to_origin(Samples samples);

/// Whether all Q lie within this share of the length of the last one from it.
bool hardly_moves(Samples samples, double share);

}  // namespace capstan
