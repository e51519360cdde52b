#include "solver/observe/surface_watch.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace capstan {
namespace {

constexpr double kInterval = 0.2;  // of kt; folds last longer
constexpr double kNever = -1;      // value in a checkpoint if there is no such time

std::optional<double> time_from(double saved) {
  return saved == kNever ? std::nullopt : std::optional(saved);
}

/// \param surface one that the mesh did not resolve
Verdict without_label(const Verdict& verdict, const SurfaceWatch& surface) {
  std::ostringstream reason;
  reason.precision(3);
  reason << "From kt = " << *surface.lost_from()
         << " on the mesh cannot represent the surface: " << surface.description()
         << ". The motion is that of the mesh then, and has no label; give the membrane a bending stiffness "
            "(E_b) or take more nodes.";
  Verdict withdrawn;
  withdrawn.evidence = verdict.evidence;
  withdrawn.evidence.margin = 0;
  withdrawn.explanation = reason.str();
  return withdrawn;
}

}  // namespace

void SurfaceWatch::add(double kt, const SurfaceQuality& quality) {
  const double rounded_kt = std::round(kt * 1e9) / 1e9;  // 7.68, not 7.680000000000005
  next_kt_ = kt + kInterval;
  worst_ = worst_of(worst_, quality);
  if (!folded_from_ && quality.folded_edges > 0) folded_from_ = rounded_kt;
  if (!lost_from_ && quality.largest_dihedral > kLyingOnEachOther) lost_from_ = rounded_kt;
}

std::string SurfaceWatch::description() const {
  std::ostringstream text;
  text.precision(3);
  text << "neighbouring triangles meet at angles of up to " << worst_.largest_dihedral << " degrees, "
       << 100 * worst_.folded_edges << " % of the edges at more than " << kFoldedEdge;
  return text.str();
}

double SurfaceWatch::clearance() const {
  return std::clamp((kLyingOnEachOther - worst_.largest_dihedral) / (kLyingOnEachOther - kFoldedEdge), 0.,
                    1.);
}

Verdict limited_by_surface(const Verdict& verdict, const SurfaceWatch& surface) {
  if (surface.lost_from()) return without_label(verdict, surface);
  Verdict limited = verdict;
  limited.evidence.margin *= surface.clearance();
  return limited;
}

void SurfaceWatch::save(StateArchive& archive) const {
  archive.put("surface", {worst_.largest_dihedral, worst_.folded_edges, worst_.smallest_angle, next_kt_,
                          folded_from_.value_or(kNever), lost_from_.value_or(kNever), worst_.longest_edge});
}

void SurfaceWatch::load(const StateArchive& archive) {
  const auto saved = archive.get("surface");
  worst_ = {saved[0], saved[1], saved[2], saved.size() > 6 ? saved[6] : 0};
  next_kt_ = saved[3];
  folded_from_ = time_from(saved[4]);
  lost_from_ = time_from(saved[5]);
}

}  // namespace capstan
