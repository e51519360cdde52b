#pragma once
// The in-plane shape vector Q = D_xy (cos 2 theta, sin 2 theta): deformation and angle as one vector, which
// is continuous where the section is circular (D_xy = 0). All functions require at least one sample.
#include <Eigen/Core>

#include "solver/observe/motion_sample.hpp"

namespace capstan {

Eigen::Vector2d shape_vector(const MotionSample& sample);

/// Smallest distance to 0 of the segments between successive Q: the curve may pass 0 between two samples.
double smallest_distance_to_origin(Samples samples);

/// Whether |Q - Q_last| <= share |Q_last| for all samples.
bool hardly_moves(Samples samples, double share);

}  // namespace capstan
