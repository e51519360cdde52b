#pragma once
// Lists in pages: `?limit=100`, and `?after=` with what the last page gave as `next`.
#include "runner/results/queries.hpp"

namespace capstan {

struct PageQuery {
  PageRequest wanted;
  CaseFilter rest;  ///< the parameters that are not of the page
  Issues issues;
};

PageQuery read_page_query(const std::vector<std::pair<std::string, std::string>>& query);

/// Adds `next`, a cursor, or null on the last page.
nlohmann::ordered_json with_next(nlohmann::ordered_json answer, const Page& page);

}  // namespace capstan
