#pragma once
// Figures as they are measured: tables of named values, for people or for programs.
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace capstan {

/// For people each table is printed as soon as it is measured; for programs all of them as one document at
/// the end.
class BenchReport {
 public:
  BenchReport(std::ostream& out, bool json) : out_(out), json_(json) {}

  /// \param rows   JSON objects with the same keys
  /// \param exact  columns whose numbers are shown in full also to people
  void add(const std::string& title, const nlohmann::ordered_json& rows, std::set<std::size_t> exact = {});
  void finish();

 private:
  std::ostream& out_;
  bool json_;
  nlohmann::ordered_json tables_ = nlohmann::ordered_json::array();
};

}  // namespace capstan
