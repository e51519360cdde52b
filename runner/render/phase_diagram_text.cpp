#include <algorithm>
#include <array>

#include "runner/queries/phase_diagram.hpp"
#include "runner/render/table.hpp"
#include "runner/study/shown_value.hpp"

namespace capstan {
namespace {

struct Mark {
  const char* name;    ///< a motion, or a state without one
  const char* text;    ///< three columns wide in the grid
  const char* colour;  ///< SGR parameters (ECMA-48)
  const char* meaning;
};

/// TB, TT, TR: the field's abbreviations. Colours that differ in lightness, too.
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

std::string painted(const std::string& text, const Mark& mark, bool coloured) {
  return coloured ? std::string("\x1b[") + mark.colour + "m" + text + "\x1b[0m" : text;
}

/// In the middle of `width` columns.
std::string centred(const std::string& text, std::size_t width) {
  const std::size_t space = width - std::min(width, text.size());
  return std::string(space / 2, ' ') + text + std::string(space - space / 2, ' ');
}

std::size_t widest(const PhaseAxis& axis) {
  std::size_t width = 0;
  for (const nlohmann::json& value : axis.values) width = std::max(width, shown_value(value).size());
  return width;
}

std::string legend(const PhaseDiagram& diagram, bool coloured) {
  std::string lines;
  for (const Mark& mark : kMarks) {
    const auto shows_it = [&](const PhaseCell& cell) {
      return &mark_of(cell) == &mark && !cell.cases.empty();
    };
    const auto has_it = [&](const auto& row) { return std::any_of(row.begin(), row.end(), shows_it); };
    if (std::any_of(diagram.rows.begin(), diagram.rows.end(), has_it))
      lines += painted(centred(mark.text, 4), mark, coloured) + "  " + mark.meaning + "\n";
  }
  return lines;
}

/// "at E_b = 0.015", one line an axis that is not drawn.
std::string fixed_text(const PhaseDiagram& diagram) {
  std::string text;
  for (const auto& [parameter, value] : diagram.at)
    text += "at " + parameter + " = " + shown_value(value) + "\n";
  return text.empty() ? text : text + "\n";
}

/// One row of cells, with its y value in front.
std::string row_text(const PhaseDiagram& diagram, std::size_t row, std::size_t margin, std::size_t cell,
                     bool coloured) {
  std::string line = aligned_right(shown_value(diagram.y.values[row]), margin) + " |";
  for (const PhaseCell& at : diagram.rows[row]) {
    const Mark& mark = mark_of(at);
    line += painted(centred(mark.text, cell), mark, coloured);
  }
  return without_trailing_spaces(line) + "\n";
}

}  // namespace

std::string render(const PhaseDiagram& diagram, bool coloured) {
  const std::size_t margin = std::max(widest(diagram.y), diagram.y.parameter.size()) + 1;
  const std::size_t cell = std::max<std::size_t>(widest(diagram.x) + 2, 4);
  std::string text = aligned_right(diagram.y.parameter, margin) + "\n";
  for (std::size_t row = diagram.rows.size(); row-- > 0;)
    text += row_text(diagram, row, margin, cell, coloured);
  text += std::string(margin, ' ') + " +" + std::string(cell * diagram.x.values.size(), '-') + "\n";
  text += std::string(margin + 2, ' ');
  for (const nlohmann::json& value : diagram.x.values) text += centred(shown_value(value), cell);
  return text + "  " + diagram.x.parameter + "\n\n" + fixed_text(diagram) + legend(diagram, coloured);
}

}  // namespace capstan
