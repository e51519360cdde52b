#include "runner/render/boundary_table.hpp"

#include <algorithm>

#include "runner/study/shown_value.hpp"
#include "solver/case/shown_number.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// The width of a band relative to its middle; null for a band that reaches an end of the range.
ordered_json relative_width(const ordered_json& band) {
  if (band[0].is_null() || band[1].is_null()) return nullptr;
  const double begin = band[0], end = band[1];
  return (end - begin) / ((begin + end) / 2);
}

/// "V = 4: ", or "" for the only row.
std::string row_text(const ordered_json& row) {
  std::string text;
  for (const auto& [parameter, value] : row["at"].items())
    text += (text.empty() ? "" : ", ") + parameter + " = " + shown_value(value);
  return text.empty() ? "" : text + ": ";
}

std::string more_text(int expected) {
  return expected > 0 ? "about " + std::to_string(expected) + " more will follow."
                      : "more will follow where the motion changes.";
}

std::string motion_text(const ordered_json& motion) {
  return motion.is_null() ? "no motion is known" : motion.get<std::string>();
}

/// Of the rows whose search has ended.
bool has_row_without_motion(const ordered_json& boundary) {
  return std::ranges::any_of(boundary["rows"], [](const ordered_json& row) {
    return row["searching"] == false && row["crossings"].empty() && row["first"].is_null();
  });
}

}  // namespace

Table boundary_table(const ordered_json& boundary) {
  const std::string along = boundary["along"];
  Table table;
  for (const ordered_json& parameter : boundary["for"]) {
    table.exact.insert(table.columns.size());
    table.columns.push_back(parameter);
  }
  for (const char* column : {"from", "to"}) table.columns.emplace_back(column);
  table.columns.push_back(along);
  for (const char* column :
       {"low", "high", "band_begin", "band_end", "band_width", "confirmed_below", "confirmed_above", "found"})
    table.columns.emplace_back(column);
  for (const ordered_json& row : boundary["rows"])
    for (const ordered_json& crossing : row["crossings"]) {
      auto& cells = table.rows.emplace_back();
      for (const ordered_json& value : row["at"]) cells.push_back(value);
      for (const char* key : {"from", "to", "value", "low", "high"}) cells.push_back(crossing[key]);
      for (const ordered_json& limit : crossing["band"]) cells.push_back(limit);
      cells.push_back(relative_width(crossing["band"]));
      for (const ordered_json& point : crossing["confirmed"]) cells.push_back(point);
      cells.push_back(crossing["found"]);
    }
  return table;
}

std::string boundary_text(const ordered_json& boundary) {
  const std::string range =
      shown_value(boundary["between"][0]) + " to " + shown_value(boundary["between"][1]);
  std::string text = as_text(boundary_table(boundary));
  for (const ordered_json& row : boundary["rows"])
    if (row["crossings"].empty() && row["searching"] == false)
      text += row_text(row) + motion_text(row["first"]) + " from " + boundary["along"].get<std::string>() +
              " = " + range + "\n";
  const ordered_json& points = boundary["points"];
  const bool is_searching = boundary["searching"] == true;
  if (is_searching)
    text += "\n" + points["ended"].dump() + " of " + points["asked"].dump() + " points have ended; " +
            more_text(points["expected"]) + "\nThen every";
  else if (points["ended"] != points["asked"])
    return text + "\n" + points["ended"].dump() + " of " + points["asked"].dump() +
           " points have ended; the study is cancelled, so the boundary is not complete.\n";
  else
    text += "\n" + points["asked"].dump() + " points. Every";
  text += " island of another motion that is wider than " +
          rounded(100 * boundary["explored"].get<double>(), 2) + " % of its " +
          boundary["along"].get<std::string>() +
          (is_searching ? " will have been looked for" : " has been looked for");
  return text + (has_row_without_motion(boundary)
                     ? ", except where no motion is known: raise until.at_most, or see capstan why.\n"
                     : ".\n");
}

}  // namespace capstan
