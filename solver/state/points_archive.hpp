#pragma once
// Points (3 x #V) in a StateArchive: one flat array, vertex by vertex.
#include <Eigen/Core>
#include <string>

#include "solver/state/state_archive.hpp"

namespace capstan {

inline void put_points(StateArchive& archive, const std::string& name, const Eigen::Matrix3Xd& points) {
  archive.put(name, std::vector<double>(points.data(), points.data() + points.size()));
}

inline Eigen::Matrix3Xd get_points(const StateArchive& archive, const std::string& name) {
  const auto data = archive.get(name);
  return Eigen::Map<const Eigen::Matrix3Xd>(data.data(), 3, Eigen::Index(data.size() / 3));
}

}  // namespace capstan
