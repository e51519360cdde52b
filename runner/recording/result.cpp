#include "runner/recording/result.hpp"

namespace capstan {

/// INSERT OR REPLACE would not fire the delete trigger, which decrements the tally of the earlier motion.
void store_result(Database& database, const std::string& case_id, const nlohmann::ordered_json& result) {
  const auto motion = result.find("motion");
  const bool is_classified = motion != result.end() && motion->is_string();
  database.execute("DELETE FROM results WHERE case_id = ?", case_id);
  database.execute("INSERT INTO results VALUES (?, nullif(?, ''), ?)", case_id,
                   is_classified ? motion->get<std::string>() : std::string(), result.dump());
}

}  // namespace capstan
