// Writes the shapes of a sphere of radius 1 + kt/2 at kt = 0, 0.5, 1, 1.5 into the given directory, for
// paraview_opens_shapes.sh. The velocity is x/(2 r), the force 3 x.
#include "solver/mesh/icosphere.hpp"
#include "solver/output/shape_writer.hpp"
#include "solver/strain_laws/strain_laws.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const capstan::Icosphere sphere = capstan::make_icosphere(3);
  const capstan::Points& directions = sphere.directions;
  const capstan::InPlaneElasticity membrane(sphere.mesh.faces, directions,
                                            *capstan::find_strain_law("skalak"), {1}, 1);
  capstan::ShapeWriter writer(argv[1], sphere.mesh.faces, membrane);
  for (int frame = 0; frame < 4; ++frame) {
    const double kt = 0.5 * frame, radius = 1 + 0.5 * kt;
    writer.write(kt, frame, radius * directions, 0.5 * directions, 3 * radius * directions);
  }
  writer.write_index();
}
