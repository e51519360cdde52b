#pragma once
#include <string>
#include <vector>

#include "runner/render/gnuplot.hpp"
#include "solver/run_directory/history_line.hpp"

namespace capstan {

/// The history of a case with its name in the key.
struct Curve {
  std::string title;
  History history;
};

/// A point of a published curve; NaN where it has no such number.
struct PublishedPoint {
  double kt, D_xy, theta_over_pi;
};

/// Points that others have published, with their source in the key.
struct PublishedSeries {
  std::string title;
  std::vector<PublishedPoint> points;
};

/// gnuplot's script for D_xy and theta over time, one above the other: the cases as curves, the published
/// points as marks.
std::string history_script(const std::vector<Curve>& curves, const std::vector<PublishedSeries>& published,
                           const PictureFormat& format);

/// gnuplot's script for the path of Q = D_xy (cos 2 theta, sin 2 theta) in its plane. A path around 0 is
/// tumbling; a path that leaves 0 aside is tank-treading; within the circle around 0 the section is nearly
/// round.
std::string path_script(const std::vector<Curve>& curves, const PictureFormat& format);

}  // namespace capstan
