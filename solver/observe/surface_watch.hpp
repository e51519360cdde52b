#pragma once
// Whether the mesh resolves the surface throughout a run. It no longer does once neighbouring triangles lie
// on each other: they rarely separate again, and from then on the motion is an artefact of the mesh. Wrinkles
// that form and vanish in every half-turn, and sharp tips, do not change the motion.
//
// Measured on 140 runs with 162 to 2562 vertices: red cells (fig. 17) reach dihedral angles of 67 degrees for
// a moment; wrinkling spheroids reach 88 to 119 degrees and have the same labels as on finer meshes; surfaces
// that crumple reach 139 to 180 degrees.
#include <optional>
#include <string>

#include "solver/mesh/surface_quality.hpp"
#include "solver/observe/classify.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

/// Degrees between the normals of neighbouring triangles beyond which they lie on each other (180: exactly).
inline constexpr double kLyingOnEachOther = 135;

class SurfaceWatch {
 public:
  /// Whether the surface should be examined at kt. It is examined at intervals of kt = 0.2: after each of
  /// many short steps it would take 4 % of the time of a run.
  bool is_due(double kt) const { return kt >= next_kt_; }
  void add(double kt, const SurfaceQuality& quality);

  /// The worst of each number, over all times added.
  const SurfaceQuality& worst() const { return worst_; }

  /// The first kt at which an edge was folded (kFoldedEdge).
  std::optional<double> folded_from() const { return folded_from_; }

  /// The first kt at which the mesh did not resolve the surface.
  std::optional<double> lost_from() const { return lost_from_; }

  /// 1 if no edge was folded, 0 if triangles lay on each other; between these limits linear in the largest
  /// dihedral angle.
  double clearance() const;

  /// "neighbouring triangles meet at angles of up to ..": the worst quality, as part of a sentence.
  std::string description() const;

  void save(StateArchive& archive) const;
  void load(const StateArchive& archive);

 private:
  SurfaceQuality worst_;
  double next_kt_ = 0;
  std::optional<double> folded_from_, lost_from_;
};

/// The verdict with the margin lowered in proportion to the clearance of the surface; undecided if the mesh
/// did not resolve the surface.
Verdict limited_by_surface(const Verdict& verdict, const SurfaceWatch& surface);

}  // namespace capstan
