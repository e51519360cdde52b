#include "runner/render/boundary_picture.hpp"

#include <algorithm>

#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// The diagram's axes may be drawn either way round.
struct Orientation {
  bool is_along_x = true;   ///< the searched parameter is drawn across
  double from = 0, to = 0;  ///< the searched range
  const PhaseAxis& rows;    ///< the other axis

  std::string point(double along, const ordered_json& row) const {
    const std::string over = shown(place_of_row(row));
    return is_along_x ? shown(along) + " " + over : over + " " + shown(along);
  }

 private:
  /// The number itself, or the position of a word.
  double place_of_row(const ordered_json& row) const {
    if (row.is_number()) return row;
    return double(std::ranges::find(rows.values, nlohmann::json(row)) - rows.values.begin());
  }
};

bool stands_at(const PhaseDiagram& diagram, const ordered_json& curve) {
  for (const auto& [parameter, value] : curve["at"].items()) {
    const auto fixed = diagram.at.find(parameter);
    if (fixed == diagram.at.end() || fixed->second != nlohmann::json(value)) return false;
  }
  return true;
}

/// A limit of the band; where that is beyond the range, the end of the range.
double limit_of_band(const ordered_json& point, int side, const Orientation& orientation) {
  const ordered_json& limit = point["band"][std::size_t(side)];
  if (limit.is_number()) return limit;
  return side == 0 ? orientation.from : orientation.to;
}

/// A closed polygon: up along the lower limits, back along the upper ones.
std::string band(const ordered_json& points, const Orientation& orientation) {
  std::string lines;
  for (std::size_t i = 0; i < points.size(); ++i)
    lines += orientation.point(limit_of_band(points[i], 0, orientation), points[i]["over"]) + "\n";
  for (std::size_t i = points.size(); i-- > 0;)
    lines += orientation.point(limit_of_band(points[i], 1, orientation), points[i]["over"]) + "\n";
  return lines;
}

/// Values, each with its limits: the columns x, y, low, high. A limit that is not known is the end of the
/// range; without both there is no bar.
std::string values(const ordered_json& points, const Orientation& orientation) {
  std::string lines;
  for (const ordered_json& point : points) {
    if (!point["value"].is_number()) continue;
    const double value = point["value"];
    const bool has_bar = point["low"].is_number() || point["high"].is_number();
    const auto limit = [&](const char* key, double end) {
      return shown(point[key].is_number() ? double(point[key]) : has_bar ? end : value);
    };
    lines += orientation.point(value, point["over"]) + " " + limit("low", orientation.from) + " " +
             limit("high", orientation.to) + "\n";
  }
  return lines;
}

/// Whether the curve joins rows along the axis. A single row may have no parameter, and the axis no name.
bool is_over(const ordered_json& curve, const PhaseAxis& axis) {
  return curve["over"].is_null() ? axis.parameter.empty() : curve["over"] == axis.parameter;
}

struct CurveStyle {
  const char *band, *values;
};

/// The band is an area and the boundary a line. A curve of one point has neither: its band is a wide bar, its
/// boundary a mark.
CurveStyle style_of(const ordered_json& curve) {
  if (curve["points"].size() == 1) return {"lines lw 10 lc rgb '#C0E69F00'", "points pt 7 ps 0.5"};
  return {"filledcurves closed fc rgb '#E69F00' fs transparent solid 0.25 noborder", "lines lw 1.5"};
}

}  // namespace

BoundaryDrawing boundary_drawing(const PhaseDiagram& diagram, const ordered_json& boundary) {
  BoundaryDrawing drawing;
  if (boundary.is_null()) return drawing;
  const std::string along = boundary["along"];
  if (diagram.x.parameter != along && diagram.y.parameter != along) return drawing;
  const bool is_along_x = diagram.x.parameter == along;
  const Orientation orientation{is_along_x, boundary["between"][0], boundary["between"][1],
                                is_along_x ? diagram.y : diagram.x};
  std::size_t number = 0;
  for (const ordered_json& curve : boundary["curves"]) {
    if (!is_over(curve, orientation.rows) || !stands_at(diagram, curve)) continue;
    const CurveStyle style = style_of(curve);
    const std::string name = std::to_string(++number), points = values(curve["points"], orientation);
    drawing.blocks += "$band_" + name + " << END\n" + band(curve["points"], orientation) + "END\n";
    drawing.behind += "$band_" + name + " with " + style.band + " notitle, ";
    if (points.empty()) continue;
    drawing.blocks += "$boundary_" + name + " << END\n" + points + "END\n";
    drawing.before += ", $boundary_" + name + " using 1:2:3:4 with " + (is_along_x ? "x" : "y") +
                      "errorbars pt 0 lw 0.8 lc rgb '#000000' notitle, $boundary_" + name +
                      " using 1:2 with " + style.values + " lc rgb '#000000' title '" +
                      (number == 1 ? "boundary" : "") + "'";
  }
  return drawing;
}

}  // namespace capstan
