#include "runner/queries/queries.hpp"
#include "runner/study/small_letters.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;

constexpr const char* kAfterAll = "~";  // sorts after all characters of ids

ordered_json texts(Statement row) {
  ordered_json all = ordered_json::array();
  while (row.step()) all.push_back(row.text(0));
  return all;
}

/// An id begins with the study's name in small letters: one range of ids, found by the index, holds all
/// candidates.
ordered_json find_studies(Database& database, const std::string& word) {
  const std::string begin = in_small_letters(word), end = begin + kAfterAll;
  const ordered_json exact = texts(database.query("SELECT id FROM studies WHERE id = ?", word));
  if (!exact.empty()) return exact;
  const ordered_json named = texts(database.query(
      "SELECT id FROM studies WHERE id >= ? AND id < ? AND name = ? ORDER BY id LIMIT 20", begin, end, word));
  if (!named.empty()) return named;
  return texts(
      database.query("SELECT id FROM studies WHERE id >= ? AND id < ? ORDER BY id LIMIT 20", begin, end));
}

ordered_json find_cases_beginning(Database& database, const std::string& word) {
  const std::string begin = in_small_letters(word), end = begin + kAfterAll;
  return texts(
      database.query("SELECT id FROM cases WHERE id >= ? AND id < ? ORDER BY id LIMIT 20", begin, end));
}

}  // namespace

ordered_json find_ids(Database& database, const std::string& word) {
  return {{"studies", find_studies(database, word)}, {"cases", find_cases_beginning(database, word)}};
}

}  // namespace capstan
