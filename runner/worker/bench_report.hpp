#pragma once
// Tables of measured numbers, for people or for programs.
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace capstan {

/// As text each table is printed as soon as it is measured; as JSON all of them are one document at the end.
class BenchReport {
 public:
  BenchReport(std::ostream& out, bool json) : out_(out), json_(json) {}

  /// \param rows   JSON objects that have the same keys: the columns
  /// \param exact  columns whose numbers are shown in full as text, too; others are rounded to four digits
  void add(const std::string& title, const nlohmann::ordered_json& rows, std::set<std::size_t> exact = {});

  /// Prints the JSON document. Does nothing for text.
  void finish();

 private:
  std::ostream& out_;
  bool json_;
  nlohmann::ordered_json tables_ = nlohmann::ordered_json::array();
};

}  // namespace capstan
