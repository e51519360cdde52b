#pragma once
// The lines of history.jsonl: the solver writes them, the daemon reads them (schema/run_directory.md).
#include <optional>
#include <string>
#include <string_view>

#include "solver/observe/observables.hpp"

namespace capstan {

/// How a missing number (NaN) is written: as null, or not at all.
enum class Missing { null, left_out };

/// One JSON object without its line end, keys in the order of the table. Numbers are the shortest decimals
/// that read back to the same bits. An infinite number becomes null, because JSON has none.
std::string to_json_line(const Record& record, Missing missing = Missing::null);

/// Nothing if the line is not a JSON object, as the last line of a killed process may be. Keys that are not
/// in the table are ignored; a value that is absent or not a number is NaN.
std::optional<Record> parse_record(std::string_view line);

}  // namespace capstan
