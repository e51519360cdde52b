#include "runner/render/phase_diagram_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "runner/render/boundary_picture.hpp"
#include "runner/study/shown_value.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

struct Symbol {
  const char* name;    ///< motion of the cell, or its state if it has no motion
  const char* title;   ///< in the key
  const char* colour;  ///< Okabe and Ito's palette
  int filled, open;    ///< gnuplot's point types
};
constexpr std::array kSymbols = {
    Symbol{"tumbling", "tumbling", "#D55E00", 5, 4},
    Symbol{"tank_treading", "tank-treading", "#0072B2", 7, 6},
    Symbol{"transition", "transition", "#E69F00", 9, 8},
    Symbol{"undecided", "undecided", "#000000", 13, 12},
    Symbol{"mixed", "cases that differ", "#CC79A7", 1, 1},
    Symbol{"diverged", "no answer", "#000000", 2, 2},
    Symbol{"failed", "no answer", "#000000", 2, 2},
};

bool is_shown_as(const PhaseCell& cell, const Symbol& symbol) {
  return !cell.cases.empty() && (cell.motion.empty() ? cell.state : cell.motion) == symbol.name;
}

bool is_filled(const PhaseCell& cell) { return cell.motion.empty() || cell.is_confirmed; }

bool has_numbers(const PhaseAxis& axis) {
  return std::all_of(axis.values.begin(), axis.values.end(),
                     [](const auto& value) { return value.is_number(); });
}

/// The place of a value on an axis: the number itself, or the position of a word.
double place(const PhaseAxis& axis, std::size_t index) {
  return has_numbers(axis) ? axis.values[index].get<double>() : double(index);
}

/// Limits half a step beyond the outermost values; a logarithmic scale where the values span more than a
/// factor of 20.
std::string scale(const char* name, const PhaseAxis& axis) {
  const double first = place(axis, 0), last = place(axis, axis.values.size() - 1);
  const bool is_logarithmic = has_numbers(axis) && first > 0 && last > 20 * first;
  const std::string range = std::string("set ") + name + "range [";
  if (is_logarithmic)
    return std::string("set logscale ") + name + "\n" + range + shown(first / 1.3) + ":" + shown(last * 1.3) +
           "]\n";
  const double step = last > first ? 0.06 * (last - first) : 1;
  return range + shown(first - step) + ":" + shown(last + step) + "]\n";
}

/// The words of an axis of words; gnuplot chooses the numbers.
std::string tics(const char* name, const PhaseAxis& axis) {
  if (axis.parameter.empty()) return std::string("unset ") + name + "tics\n";
  if (has_numbers(axis)) return "";
  std::string list;
  for (std::size_t i = 0; i < axis.values.size(); ++i)
    list += (i > 0 ? ", " : "") + quoted_text(shown_value(axis.values[i])) + " " + shown(place(axis, i));
  return std::string("set ") + name + "tics (" + list + ")\n";
}

/// The points of one symbol as a block of data: x and y.
std::string points(const PhaseDiagram& diagram, const Symbol& symbol, bool filled) {
  std::string lines;
  for (std::size_t row = 0; row < diagram.rows.size(); ++row)
    for (std::size_t column = 0; column < diagram.rows[row].size(); ++column) {
      const PhaseCell& cell = diagram.rows[row][column];
      if (is_shown_as(cell, symbol) && is_filled(cell) == filled)
        lines += shown(place(diagram.x, column)) + " " + shown(place(diagram.y, row)) + "\n";
    }
  return lines;
}

struct Series {
  std::string block, data, plot;
};

std::string marks(const std::string& what, int type, const std::string& colour, const std::string& title) {
  return what + " with points pt " + std::to_string(type) + " ps 0.9 lc rgb '" + colour + "' " +
         (title.empty() ? "notitle" : "title '" + title + "'");
}

/// Each motion stands in the key once, and what open marks mean once for all.
std::vector<Series> all_series(const PhaseDiagram& diagram) {
  std::vector<Series> series;
  bool has_open = false;
  for (const Symbol& symbol : kSymbols) {
    std::string title = symbol.title;
    for (const bool filled : {true, false}) {
      std::string data = points(diagram, symbol, filled);
      if (data.empty()) continue;
      has_open = has_open || !filled;
      const std::string block = std::string("$") + symbol.name + (filled ? "" : "_not_confirmed");
      series.push_back(
          {block, std::move(data),
           marks(block, filled ? symbol.filled : symbol.open, symbol.colour, std::exchange(title, ""))});
    }
  }
  if (has_open) series.push_back({"", "", marks("NaN", 6, "#606060", "open: not confirmed")});
  return series;
}

/// Height over width of a picture with this number of entries in its key of two columns.
double height_with(std::size_t entries) { return 0.72 + 0.065 * std::ceil(double(entries) / 2); }

/// Stars, crosses, ..
std::vector<Series> published_series_of(const std::vector<PublishedBoundary>& published) {
  constexpr std::array kPointTypes = {3, 2, 1, 10, 14};
  std::vector<Series> series;
  for (const PublishedBoundary& boundary : published) {
    std::string data;
    for (const auto& [x, y] : boundary.points) data += shown(x) + " " + shown(y) + "\n";
    const std::string number = std::to_string(series.size() + 1), block = "$published_" + number;
    const int type = kPointTypes[series.size() % kPointTypes.size()];
    series.push_back({block, std::move(data),
                      block + " with points pt " + std::to_string(type) +
                          " ps 1.8 lw 1.5 lc rgb 'black' title " + quoted_text(boundary.title)});
  }
  return series;
}

std::string title(const PhaseDiagram& diagram) {
  std::string text;
  for (const auto& [parameter, value] : diagram.at)
    text += (text.empty() ? "" : ", ") + parameter + " = " + shown_value(value);
  return text.empty() ? "" : "set title " + quoted_text(text) + " noenhanced\n";
}

}  // namespace

std::string phase_diagram_script(const PhaseDiagram& diagram, const nlohmann::ordered_json& boundary,
                                 const std::vector<PublishedBoundary>& published,
                                 const PictureFormat& format) {
  std::vector<Series> all;  // our marks are drawn over those of others
  if (has_numbers(diagram.x) && has_numbers(diagram.y)) all = published_series_of(published);
  std::ranges::move(all_series(diagram), std::back_inserter(all));
  std::string script = picture_head(format, height_with(all.size() + 1)) + title(diagram) +
                       scale("x", diagram.x) + scale("y", diagram.y) + tics("x", diagram.x) +
                       tics("y", diagram.y) + "set xlabel " + symbol(diagram.x.parameter) + "\nset ylabel " +
                       symbol(diagram.y.parameter) +
                       "\nset key below Left reverse maxcols 2 samplen 0.6 spacing 1.1 width -4\n";
  const BoundaryDrawing drawing = boundary_drawing(diagram, boundary);
  script += drawing.blocks;
  std::string plots;
  for (const Series& each : all) {
    if (!each.block.empty()) script += each.block + " << END\n" + each.data + "END\n";
    plots += (plots.empty() ? "plot " + drawing.behind : ", \\\n     ") + each.plot;
  }
  return script + (plots.empty() ? "plot NaN notitle" : plots + drawing.before) + "\n";
}

}  // namespace capstan
