#pragma once
// The shapes of a sphere of radius 1 + kt at kt = 0, 0.5, 1, as the solver writes them.
#include "solver/mesh/icosphere.hpp"
#include "solver/output/shape_writer.hpp"
#include "solver/strain_laws/strain_laws.hpp"

namespace capstan {

inline Icosphere recorded_sphere() { return make_icosphere(1); }

/// \param directory  of the run
inline void record_spheres(const std::filesystem::path& directory) {
  const Icosphere sphere = recorded_sphere();
  const Points& directions = sphere.directions;
  ShapeWriter writer(directory, sphere.mesh.faces,
                     InPlaneElasticity(sphere.mesh.faces, directions, *find_strain_law("skalak"), {1}, 1));
  for (int frame = 0; frame < 3; ++frame) {
    const double kt = 0.5 * frame;
    writer.write(kt, frame, (1 + kt) * directions, directions, -2 * directions);
  }
  writer.write_index();
}

}  // namespace capstan
