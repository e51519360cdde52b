#include "runner/cli/pictured_shapes.hpp"

#include <cmath>

#include "runner/cli/case_shapes.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

constexpr double kSameTime = 1e-6;

PlanePoint in_plane(std::span<const double> vectors, std::size_t vertex) {
  return {vectors[3 * vertex], vectors[3 * vertex + 1]};
}

/// Visits the shapes of a case together with its marker, which the first shape defines.
template <class Visit>
void for_each_shape_with_marker(Client& client, const std::string& path, Visit visit) {
  std::size_t marker = 0;
  bool is_first = true;
  for_each_shape(client, path, [&](const VisitedShape& shape) {
    if (is_first) marker = marker_vertex(shape.positions);
    is_first = false;
    visit(shape, marker);
  });
}

Profile profile_of(const std::string& title, const VisitedShape& shape, std::size_t marker) {
  return {title, section_in_plane_of_shear(shape.positions, shape.triangles),
          in_plane(shape.positions, marker)};
}

Profile last_profile(Client& client, const PicturedCase& c) {
  Profile last;
  for_each_shape_with_marker(client, c.path, [&](const VisitedShape& shape, std::size_t marker) {
    last = profile_of(c.title, shape, marker);
  });
  return last;
}

void add_profiles(Client& client, const PicturedCase& c, const std::vector<double>& times,
                  std::vector<ProfilePanel>& panels) {
  for_each_shape_with_marker(client, c.path, [&](const VisitedShape& shape, std::size_t marker) {
    for (std::size_t i = 0; i < times.size(); ++i)
      if (std::abs(shape.kt - times[i]) < kSameTime)
        panels[i].profiles.push_back(profile_of(c.title, shape, marker));
  });
}

}  // namespace

std::vector<ProfilePanel> profile_panels(Client& client, const std::vector<PicturedCase>& cases,
                                         const std::vector<double>& times) {
  if (times.empty()) {
    ProfilePanel panel;
    for (const PicturedCase& c : cases) panel.profiles.push_back(last_profile(client, c));
    return {panel};
  }
  std::vector<ProfilePanel> panels;
  for (const double kt : times) panels.push_back({"kt = " + shown(kt), {}});
  for (std::size_t n = 0; n < cases.size(); ++n) {
    add_profiles(client, cases[n], times, panels);
    for (const ProfilePanel& panel : panels)
      if (panel.profiles.size() != n + 1)
        throw std::invalid_argument(cases[n].title + " has no shape at " + panel.title +
                                    "; outputs.shapes_every says at which times shapes are recorded");
  }
  return panels;
}

std::vector<Trajectory> trajectories(Client& client, const std::vector<PicturedCase>& cases) {
  std::vector<Trajectory> all;
  for (const PicturedCase& c : cases) {
    Trajectory& trajectory = all.emplace_back(Trajectory{c.title, {}});
    for_each_shape_with_marker(client, c.path, [&](const VisitedShape& shape, std::size_t marker) {
      trajectory.points.push_back({in_plane(shape.positions, marker), in_plane(shape.velocities, marker)});
    });
  }
  return all;
}

}  // namespace capstan
