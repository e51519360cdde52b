#include "runner/render/phase_diagram_text.hpp"

#include <algorithm>
#include <array>

#include "runner/render/table.hpp"
#include "runner/study/shown_value.hpp"
#include "runner/study/small_letters.hpp"

namespace capstan {
namespace {

/// How a cell of the grid is shown.
struct Mark {
  const char* name;    ///< motion of the cell, or its state if it has no motion yet
  const char* text;    ///< up to two characters
  const char* colour;  ///< SGR parameters (ECMA-48)
  const char* meaning;
};

/// TB, TT and TR are the usual abbreviations. The colours also differ in lightness, for readers who are
/// colour-blind.
constexpr std::array kMarks = {
    Mark{"tumbling", "TB", "1;97;41", "tumbling"},
    Mark{"tank_treading", "TT", "1;97;44", "tank-treading"},
    Mark{"transition", "TR", "1;30;43", "transition"},
    Mark{"undecided", "?", "1;30;47", "undecided: the run was too short, or its surface was lost"},
    Mark{"mixed", "+", "1;97;45", "cases that differ"},
    Mark{"failed", "!", "31", "failed"},
    Mark{"diverged", "x", "31", "diverged"},
    Mark{"cancelled", "-", "90", "cancelled"},
    Mark{"running", "~", "36", "running"},
    Mark{"queued", ".", "90", "queued"},
    Mark{"", " ", "0", ""},
};

const Mark& mark_of(const PhaseCell& cell) {
  const std::string& name = cell.motion.empty() ? cell.state : cell.motion;
  return *std::find_if(kMarks.begin(), kMarks.end() - 1, [&](const Mark& mark) { return name == mark.name; });
}

/// In small letters where the motion is not confirmed.
std::string text_of(const PhaseCell& cell) {
  const std::string text = mark_of(cell).text;
  return cell.motion.empty() || cell.is_confirmed ? text : in_small_letters(text);
}

bool is_in_small_letters(const PhaseCell& cell) { return text_of(cell) != mark_of(cell).text; }

std::string painted(const std::string& text, const Mark& mark, bool coloured) {
  return coloured ? std::string("\x1b[") + mark.colour + "m" + text + "\x1b[0m" : text;
}

/// The text in the middle of `width` columns.
std::string centred(const std::string& text, std::size_t width) {
  const std::size_t space = width - std::min(width, text.size());
  return std::string(space / 2, ' ') + text + std::string(space - space / 2, ' ');
}

std::size_t max_width(const PhaseAxis& axis) {
  std::size_t width = 0;
  for (const nlohmann::json& value : axis.values) width = std::max(width, shown_value(value).size());
  return width;
}

/// One line for each mark that occurs.
std::string legend(const PhaseDiagram& diagram, bool coloured) {
  std::string lines;
  for (const Mark& mark : kMarks) {
    const auto has_mark = [&](const PhaseCell& cell) {
      return &mark_of(cell) == &mark && !cell.cases.empty();
    };
    const auto contains_mark = [&](const auto& row) { return std::any_of(row.begin(), row.end(), has_mark); };
    if (std::any_of(diagram.rows.begin(), diagram.rows.end(), contains_mark))
      lines += painted(centred(mark.text, 4), mark, coloured) + "  " + mark.meaning + "\n";
  }
  return lines;
}

/// Says what small letters mean, if there are any.
std::string legend_of_small_letters(const PhaseDiagram& diagram) {
  for (const auto& row : diagram.rows)
    if (std::any_of(row.begin(), row.end(), is_in_small_letters))
      return "\nIn small letters: not confirmed. The run at the coarser resolution has another label, or the "
             "error "
             "is larger\nthan the label tolerates (capstan results shows error and margin).\n";
  return "";
}

/// "at E_b = 0.015", one line for each axis that is not drawn.
std::string fixed_text(const PhaseDiagram& diagram) {
  std::string text;
  for (const auto& [parameter, value] : diagram.at)
    text += "at " + parameter + " = " + shown_value(value) + "\n";
  return text.empty() ? text : text + "\n";
}

/// The y value and the cells of a row.
/// \param margin, cell  widths of the y value and of a cell
std::string row_text(const PhaseDiagram& diagram, std::size_t row, std::size_t margin, std::size_t cell,
                     bool coloured) {
  std::string line = aligned_right(shown_value(diagram.y.values[row]), margin) + " |";
  for (const PhaseCell& at : diagram.rows[row]) {
    const Mark& mark = mark_of(at);
    line += painted(centred(text_of(at), cell), mark, coloured);
  }
  return without_trailing_spaces(line) + "\n";
}

/// The columns that at least half of the rows have points at, and how many points stand in the others: a
/// search for a boundary computes other values in each row, and all of them would not fit on a screen.
std::pair<PhaseDiagram, std::size_t> without_sparse_columns(const PhaseDiagram& diagram) {
  PhaseDiagram shown{{diagram.x.parameter, {}}, diagram.y, diagram.at, {}};
  shown.rows.resize(diagram.rows.size());
  std::size_t left_out = 0;
  for (std::size_t column = 0; column < diagram.x.values.size(); ++column) {
    const auto has_points = [&](const auto& row) { return !row[column].cases.empty(); };
    const auto points = std::size_t(std::ranges::count_if(diagram.rows, has_points));
    if (2 * points < diagram.rows.size()) {
      left_out += points;
      continue;
    }
    shown.x.values.push_back(diagram.x.values[column]);
    for (std::size_t row = 0; row < diagram.rows.size(); ++row)
      shown.rows[row].push_back(diagram.rows[row][column]);
  }
  return {shown, left_out};
}

std::string text_of_left_out(std::size_t points) {
  if (points == 0) return "";
  return "\nPoints at other values, which capstan results lists: " + std::to_string(points) + "\n";
}

}  // namespace

std::string phase_diagram_text(const PhaseDiagram& all, bool coloured) {
  const auto [diagram, left_out] = without_sparse_columns(all);
  const std::size_t margin = std::max(max_width(diagram.y), diagram.y.parameter.size()) + 1;
  const std::size_t cell = std::max<std::size_t>(max_width(diagram.x) + 2, 4);
  std::string text = aligned_right(diagram.y.parameter, margin) + "\n";
  for (std::size_t row = diagram.rows.size(); row-- > 0;)
    text += row_text(diagram, row, margin, cell, coloured);
  text += std::string(margin, ' ') + " +" + std::string(cell * diagram.x.values.size(), '-') + "\n";
  text += std::string(margin + 2, ' ');
  for (const nlohmann::json& value : diagram.x.values) text += centred(shown_value(value), cell);
  return text + "  " + diagram.x.parameter + "\n\n" + fixed_text(diagram) + legend(diagram, coloured) +
         legend_of_small_letters(diagram) + text_of_left_out(left_out);
}

}  // namespace capstan
