#include "runner/render/shape_picture.hpp"

#include <algorithm>
#include <cmath>

#include "runner/render/curve_style.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

std::string coordinates(const PlanePoint& point) { return rounded(point.x, 6) + " " + rounded(point.y, 6); }

/// A data block of gnuplot. Closed curves are separated by blank lines, and return to their first point.
std::string section_block(const std::string& name, const std::vector<ClosedCurve>& section) {
  std::string block = name + " << END\n";
  for (const ClosedCurve& curve : section) {
    for (const PlanePoint& point : curve) block += coordinates(point) + "\n";
    block += coordinates(curve.front()) + "\n\n";
  }
  return block + "END\n";
}

std::string ranges(double reach) {
  const std::string end = rounded(reach, 3);
  return "set size ratio -1\nset xrange [-" + end + ":" + end + "]\nset yrange [-" + end + ":" + end + "]\n";
}

std::string axis_labels() {
  return "set xlabel '{/:Italic x}/{/:Italic a}'\nset ylabel '{/:Italic y}/{/:Italic a}' rotate by 0\n";
}

std::string key_below(std::size_t entries) {
  return entries > 1 ? "set key below Left reverse maxcols 3 samplen 2 spacing 1.1\n" : "unset key\n";
}

double reach_of(const PlanePoint& point) { return std::max(std::abs(point.x), std::abs(point.y)); }

/// The largest coordinate of a picture with a margin, in steps of 0.1.
double rounded_up(double reach) { return std::ceil(10 * 1.05 * reach) / 10; }

double reach_of(const std::vector<ProfilePanel>& panels) {
  double reach = 0;
  for (const ProfilePanel& panel : panels)
    for (const Profile& profile : panel.profiles)
      for (const ClosedCurve& curve : profile.section)
        for (const PlanePoint& point : curve) reach = std::max(reach, reach_of(point));
  return rounded_up(reach);
}

std::string block_name(std::size_t panel, std::size_t profile) {
  return "$panel" + std::to_string(panel + 1) + "_" + std::to_string(profile + 1);
}

std::string data_blocks(const std::vector<ProfilePanel>& panels) {
  std::string blocks;
  for (std::size_t p = 0; p < panels.size(); ++p)
    for (std::size_t i = 0; i < panels[p].profiles.size(); ++i) {
      const Profile& profile = panels[p].profiles[i];
      const std::string name = block_name(p, i);
      blocks += section_block(name, profile.section) + name + "_marker << END\n" +
                coordinates(profile.marker) + "\nEND\n";
    }
  return blocks;
}

/// \param has_titles  whether its cases stand in the key
std::string panel_plot(const ProfilePanel& panel, std::size_t number, bool has_titles) {
  std::string plot = "set title " + quoted_text(panel.title) + "\n";
  for (std::size_t i = 0; i < panel.profiles.size(); ++i) {
    const std::string name = block_name(number, i);
    plot += (i > 0 ? ", \\\n     " : "plot ") + name + " with lines " + curve_style(i) +
            (has_titles ? " title " + quoted_text(panel.profiles[i].title) + " noenhanced" : " notitle") +
            ", \\\n     " + name + "_marker with points pt 7 ps 0.6 " + curve_colour(i) + " notitle";
  }
  return plot + "\n";
}

/// One panel with its axes, as large as the picture.
std::string single_panel(const ProfilePanel& panel, const PictureFormat& format) {
  return picture_head(format, 1) + ranges(reach_of({panel})) + axis_labels() +
         key_below(panel.profiles.size()) + data_blocks({panel}) + panel_plot(panel, 0, true);
}

/// Panels without numbers, for which they are too small: tics are one a apart. The key stands once, below.
std::string panels_in_rows(const std::vector<ProfilePanel>& panels, const PictureFormat& format) {
  constexpr double kTitle = 0.2, kGap = 0.1, kKeyRow = 0.14;  // of the width of a panel
  const std::size_t columns = std::min<std::size_t>(3, panels.size());
  const std::size_t rows = (panels.size() + columns - 1) / columns;
  const std::size_t cases = panels.front().profiles.size(), key_rows = cases > 1 ? (cases + 2) / 3 : 0;
  const double key = kKeyRow * double(key_rows);
  const double width = double(columns) * (1 + kGap) + kGap, height = double(rows) * (1 + kTitle) + kGap + key;
  std::string script =
      picture_head(format, height / width) + ranges(reach_of(panels)) +
      "set border 31\nset tics 1 scale 0.4\nset format ''\nset title offset 0,-0.7\n" +
      (key_rows > 0 ? "set key at screen 0.5,0.01 center bottom vertical Left reverse samplen 2 maxrows " +
                          std::to_string(key_rows) + "\n"
                    : "unset key\n") +
      data_blocks(panels) + "set multiplot layout " + std::to_string(rows) + "," + std::to_string(columns) +
      " margins screen " + rounded(kGap / width, 4) + "," + rounded(1 - kGap / width, 4) + "," +
      rounded((kGap + key) / height, 4) + "," + rounded(1 - kTitle / height, 4) + " spacing screen " +
      rounded(kGap / width, 4) + "," + rounded(kTitle / height, 4) + "\n";
  for (std::size_t i = 0; i < panels.size(); ++i) script += panel_plot(panels[i], i, i + 1 == panels.size());
  return script + "unset multiplot\n";
}

double reach_of(const std::vector<Trajectory>& trajectories, double arrow) {
  double reach = 0;
  for (const Trajectory& trajectory : trajectories)
    for (const TrajectoryPoint& point : trajectory.points)
      reach = std::max(
          {reach, reach_of(point.place),
           reach_of({point.place.x + arrow * point.velocity.x, point.place.y + arrow * point.velocity.y})});
  return rounded_up(reach);
}

std::string trajectory_block(const std::string& name, const Trajectory& trajectory) {
  std::string block = name + " << END\n";
  for (const TrajectoryPoint& point : trajectory.points)
    block += coordinates(point.place) + " " + coordinates(point.velocity) + "\n";
  return block + "END\n";
}

}  // namespace

std::string profile_script(const std::vector<ProfilePanel>& panels, const PictureFormat& format) {
  return panels.size() == 1 ? single_panel(panels.front(), format) : panels_in_rows(panels, format);
}

std::string trajectory_script(const std::vector<Trajectory>& trajectories, const PictureFormat& format) {
  constexpr double kArrow = 0.25;  // length / a of an arrow for a velocity of a k
  std::string script = picture_head(format, 1) + ranges(reach_of(trajectories, kArrow)) + axis_labels() +
                       key_below(trajectories.size());
  std::string plot;
  for (std::size_t i = 0; i < trajectories.size(); ++i) {
    const std::string name = "$case" + std::to_string(i + 1);
    script += trajectory_block(name, trajectories[i]);
    plot += (i > 0 ? ", \\\n     " : "plot ") + name + " using 1:2 with lines " + curve_style(i) + " title " +
            quoted_text(trajectories[i].title) + " noenhanced, \\\n     " + name + " using 1:2:(" +
            rounded(kArrow) + "*$3):(" + rounded(kArrow) + "*$4) with vectors size 0.04,25 lw 0.8 " +
            curve_colour(i) + " notitle";
  }
  return script + plot + "\n";
}

}  // namespace capstan
