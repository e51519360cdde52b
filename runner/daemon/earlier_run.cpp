#include "runner/daemon/earlier_run.hpp"

#include "runner/daemon/case_rows.hpp"
#include "solver/case/equal_steps.hpp"

namespace capstan {
namespace {

std::optional<Until> end_of_case(const std::string& document) {
  const ParsedCase parsed = parse_stored_case(nlohmann::json::parse(document));
  return parsed.value ? std::optional(parsed.value->until) : std::nullopt;
}

}  // namespace

std::optional<std::string> earlier_run(Database& database, const std::string& case_id) {
  Statement row = database.query(
      "SELECT earlier.id, earlier.document, earlier.kt, later.document FROM cases later"
      " JOIN cases earlier ON earlier.steps_id = later.steps_id AND earlier.state = 'done'"
      " WHERE later.id = ? AND later.steps_id <> '' ORDER BY earlier.kt DESC",
      case_id);
  while (row.step()) {
    const std::optional<Until> earlier = end_of_case(row.text(1)), later = end_of_case(row.text(3));
    if (earlier && later && passes_end_of(*earlier, row.real(2), *later)) return row.text(0);
  }
  return std::nullopt;
}

}  // namespace capstan
