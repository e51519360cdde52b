#include "solver/output/run_warnings.hpp"

#include <sstream>

#include "solver/case/case_warnings.hpp"

namespace capstan {
namespace {

std::string volume_drift(const Case& c, const RunStatistics& statistics) {
  constexpr double kMax = 0.01;
  if (!(statistics.volume_drift > kMax)) return "";
  std::ostringstream text;
  text.precision(2);
  text << "the volume drifted by " << 100 * statistics.volume_drift << " %, more than 1 %: use "
       << (c.has_grid() ? "a smaller dx with nodes to match, or \"fluid\": \"stokes\"" : "more nodes");
  return text.str();
}

std::string folded_surface(const Case& c, const SurfaceWatch& surface) {
  if (!surface.folded_from()) return "";
  std::ostringstream text;
  text.precision(3);
  text << "the surface is not smooth on this mesh from kt = " << *surface.folded_from()
       << " on: " << surface.description() << "; use "
       << (c.has_bending() ? "a larger bending stiffness E_b" : "a bending stiffness (E_b = 0.005)")
       << " or more nodes";
  return text.str();
}

std::string collapsed_triangles(const SurfaceWatch& surface) {
  constexpr double kMin = 5;  // degrees; drawn-out capsules at Ca = 1 come to 6
  if (surface.worst().smallest_angle >= kMin) return "";
  std::ostringstream text;
  text.precision(2);
  text << "triangles of the mesh have collapsed to angles of " << surface.worst().smallest_angle
       << " degrees, where the membrane's forces are inaccurate; use a larger bending stiffness E_b, a "
          "smaller Ca or "
          "more nodes";
  return text.str();
}

}  // namespace

std::vector<std::string> run_warnings(const Case& c, const RunStatistics& statistics,
                                      const SurfaceWatch& surface) {
  std::vector<std::string> warnings = case_warnings(c);
  for (std::string text :
       {volume_drift(c, statistics), folded_surface(c, surface), collapsed_triangles(surface)})
    if (!text.empty()) warnings.push_back(std::move(text));
  return warnings;
}

}  // namespace capstan
