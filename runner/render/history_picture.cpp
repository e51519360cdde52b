#include "runner/render/history_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>

#include "runner/render/curve_style.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

std::string block_of(std::size_t curve) { return "$case" + std::to_string(curve + 1); }

std::string value(double number) { return std::isfinite(number) ? rounded(number, 8) : "NaN"; }

/// kt, D_xy and theta of each record.
std::string data_blocks(const std::vector<Curve>& curves) {
  std::string blocks;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    blocks += block_of(i) + " << END\n";
    for (const Record& record : curves[i].history)
      blocks += value(record["kt"]) + " " + value(record["D_xy"]) + " " + value(record["theta"]) + "\n";
    blocks += "END\n";
  }
  return blocks;
}

std::string mark_block_of(std::size_t series) { return "$published" + std::to_string(series + 1); }

/// kt, D_xy and theta/pi of each point.
std::string data_blocks(const std::vector<PublishedSeries>& published) {
  std::string blocks;
  for (std::size_t i = 0; i < published.size(); ++i) {
    blocks += mark_block_of(i) + " << END\n";
    for (const PublishedPoint& point : published[i].points)
      blocks += value(point.kt) + " " + value(point.D_xy) + " " + value(point.theta_over_pi) + "\n";
    blocks += "END\n";
  }
  return blocks;
}

std::string mark_style(std::size_t series) {
  constexpr std::array kMarks = {4,  6, 8, 10,
                                 12, 1, 2};  // squares, circles, triangles, ...: gnuplot's numbers
  return "lc rgb 'black' lw 0.7 ps 0.5 pt " + std::to_string(kMarks[series % kMarks.size()]);
}

/// Parts of a plot command. \param columns  of a block, as after `using`
std::vector<std::string> lines_of(const std::vector<Curve>& curves, const std::string& columns) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < curves.size(); ++i)
    lines.push_back(block_of(i) + " using " + columns + " with lines " + curve_style(i) + " notitle");
  return lines;
}

/// The same for the series that have this quantity.
std::vector<std::string> marks_of(const std::vector<PublishedSeries>& published, const std::string& columns,
                                  double PublishedPoint::*quantity) {
  std::vector<std::string> marks;
  for (std::size_t i = 0; i < published.size(); ++i)
    if (std::ranges::any_of(published[i].points,
                            [&](const auto& point) { return std::isfinite(point.*quantity); }))
      marks.push_back(mark_block_of(i) + " using " + columns + " with points " + mark_style(i) + " notitle");
  return marks;
}

std::vector<std::string> key_entries(const std::vector<Curve>& curves,
                                     const std::vector<PublishedSeries>& published) {
  std::vector<std::string> entries;
  const auto add = [&](const std::string& style, const std::string& title) {
    entries.push_back("keyentry with " + style + " title " + quoted_text(title) + " noenhanced");
  };
  for (std::size_t i = 0; i < curves.size(); ++i) add("lines " + curve_style(i), curves[i].title);
  for (std::size_t i = 0; i < published.size(); ++i) add("points " + mark_style(i), published[i].title);
  return entries;
}

std::string plot(std::initializer_list<std::vector<std::string>> lists) {
  std::string command;
  for (const std::vector<std::string>& parts : lists)
    for (const std::string& part : parts) command += (command.empty() ? "plot " : ", \\\n     ") + part;
  return (command.empty() ? "plot NaN notitle" : command) + "\n";
}

/// The end of the longest run, as gnuplot's range; "*", gnuplot's choice, before there is one.
std::string end_of(const std::vector<Curve>& curves) {
  double end = 0;
  for (const Curve& curve : curves)
    if (!curve.history.empty()) end = std::max(end, curve.history.back()["kt"]);
  return end > 0 ? value(end) : "*";
}

/// Rows of the key, of as many columns as the titles leave room for.
int key_rows(const std::vector<Curve>& curves, const std::vector<PublishedSeries>& published,
             PictureWidth width) {
  constexpr double kPanel = 0.8, kSample = 0.05, kCharacter = 0.016;  // measured, of a column of a page
  std::size_t longest = 1;
  for (const Curve& curve : curves) longest = std::max(longest, curve.title.size());
  for (const PublishedSeries& series : published) longest = std::max(longest, series.title.size());
  const double room = kPanel * (width == PictureWidth::two_columns ? 2 : 1);
  const int columns = std::clamp(int(room / (kSample + kCharacter * double(longest))), 1, 3);
  return (int(curves.size() + published.size()) + columns - 1) / columns;
}

/// Two panels of a fixed size with the key below them: all heights are in units of the picture's width.
struct Panels {
  double height, below;  ///< of the picture; of axis labels and key

  Panels(int key_rows, PictureWidth width) {
    const double scale = width == PictureWidth::two_columns ? 0.5 : 1;
    below = scale * (0.13 + 0.037 * key_rows);
    height = scale * 0.92 + below;
  }
  std::string command() const {
    return "set multiplot layout 2,1 margins screen 0.16,0.96," + rounded(below / height, 4) +
           ",0.98 spacing screen " + rounded(0.07 / height, 4) + "\n";
  }
};

}  // namespace

std::string history_script(const std::vector<Curve>& curves, const std::vector<PublishedSeries>& published,
                           const PictureFormat& format) {
  const int rows = key_rows(curves, published, format.width);
  const Panels panels(rows, format.width);
  return picture_head(format, panels.height) + data_blocks(curves) + data_blocks(published) +
         "set key at screen 0.56,0.01 center bottom vertical Left reverse maxrows " + std::to_string(rows) +
         " samplen 2 spacing 1.1\n" + panels.command() +
         "set format y '%g'\nset xrange [0:" + end_of(curves) + "]\nset ylabel " + symbol("D_xy") +
         "\nset yrange [0:*]\n" +
         plot({lines_of(curves, "1:2"), marks_of(published, "1:2", &PublishedPoint::D_xy)}) + "set xlabel " +
         symbol("kt") + "\nset ylabel " + symbol("theta") + "\nset yrange [*:*]\n" +
         plot({lines_of(curves, "1:($3/pi)"), marks_of(published, "1:3", &PublishedPoint::theta_over_pi),
               key_entries(curves, published)}) +
         "unset multiplot\n";
}

std::string path_script(const std::vector<Curve>& curves, const PictureFormat& format) {
  return picture_head(format, 1.1) + data_blocks(curves) +
         "set key below Left reverse maxcols 3 samplen 2 spacing 1.1\n" +
         "set size ratio -1\nset zeroaxis lw 0.5 lc rgb '#999999'\n"
         "set object circle at 0,0 size 0.06 fc rgb '#dddddd' fs solid noborder behind\nset xlabel " +
         quoted_text("{/:Italic D}_{xy} cos 2{/:Italic θ}") + "\nset ylabel " +
         quoted_text("{/:Italic D}_{xy} sin 2{/:Italic θ}") + "\n" +
         plot({lines_of(curves, "($2*cos(2*$3)):($2*sin(2*$3))"), key_entries(curves, {})});
}

}  // namespace capstan
