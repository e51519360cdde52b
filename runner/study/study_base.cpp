#include "runner/study/study_base.hpp"

#include "runner/study/axis.hpp"

namespace capstan {
namespace {

using nlohmann::json;

/// With more than one value: a list, or a range.
int axes_of_numbers(const json& document) {
  int count = 0;
  const json axes = document.value("axes", json::object());
  for (const auto& [name, values] : axes.items())
    if (values.size() > 1 && takes_numbers(name)) ++count;
  return count;
}

}  // namespace

bool ends_runs_early(const json& document) {
  const json until = document["base"].value("until", json::object());
  const bool may_choose = until.is_object() && !until.contains("classified");
  return may_choose && (document.contains("boundary") || axes_of_numbers(document) >= 2);
}

json base_of(const json& document) {
  json base = document["base"];
  if (ends_runs_early(document)) base["until"]["classified"] = true;
  return base;
}

}  // namespace capstan
