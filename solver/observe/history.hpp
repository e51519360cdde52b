#pragma once
// What is recorded of a run in time: one Record a line of history.jsonl (schema/run_directory.md).
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

struct Record {
  double kt = 0;
  double D_xy = 0;
  double theta = 0;  ///< angle of the major axis with x, radians, unwrapped
  double psi = 0;    ///< mean angle of material points against that axis, radians, unwrapped, 0 at the start
  double volume = 0;
  double area = 0;
  int iterations = 0;  ///< of the flow, since the last record
  double error = 0;    ///< estimated, of the last flow solution
  bool operator==(const Record&) const = default;
};
using History = std::vector<Record>;

/// One line of JSON without its end. Numbers are the shortest that read back to the same bits; JSON has none
/// that are not finite, they become null.
std::string to_json_line(const Record& record);

/// Nothing if the line is not a whole record, as the last one of a process that died may be.
std::optional<Record> parse_record(std::string_view line);

}  // namespace capstan
