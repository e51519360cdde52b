#pragma once
// Whether the mesh could represent the surface throughout a run. It cannot once neighbouring triangles lie on
// each other; they rarely part again, and the motion is that of the mesh then. Wrinkles that come and go with
// every half-turn, and sharp tips, leave the motion as it is.
//
// Measured on 140 runs with 162 to 2562 vertices: red cells (fig. 17) reach 67 degrees for a moment,
// wrinkling spheroids 88 to 119 degrees with the labels of finer meshes; surfaces that crumple reach 139 to
// 180 degrees.
#include <optional>
#include <string>

#include "solver/mesh/surface_quality.hpp"
#include "solver/observe/classify.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

/// Degrees between the normals of neighbouring triangles; at 180 one lies on the other.
inline constexpr double kLyingOnEachOther = 135;

class SurfaceWatch {
 public:
  /// Whether enough time has gone by for another look: a look at every short step would cost 4 % of a run.
  bool is_due(double kt) const { return kt >= next_look_; }
  void look(double kt, const SurfaceQuality& seen);

  const SurfaceQuality& worst() const { return worst_; }

  /// When an edge was folded (kFoldedEdge) for the first time.
  std::optional<double> folded_from() const { return folded_from_; }

  /// When the mesh could not represent the surface for the first time.
  std::optional<double> lost_from() const { return lost_from_; }

  /// How far the surface kept from being lost: 1 where no edge was folded, 0 where triangles lay on each
  /// other.
  double clearance() const;

  /// "neighbouring triangles meet at angles of up to ...": how much is folded, for a sentence.
  std::string in_words() const;

  void save(StateArchive& archive) const;
  void load(const StateArchive& archive);

 private:
  SurfaceQuality worst_;
  double next_look_ = 0;  ///< kt
  std::optional<double> folded_from_, lost_from_;
};

/// The verdict with what the surface says of it: folded edges lower its margin, and a lost surface takes its
/// label.
Verdict judged_on(const SurfaceWatch& surface, const Verdict& verdict);

}  // namespace capstan
