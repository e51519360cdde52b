#pragma once
// Lists in pages: `?limit=100`, and `?after=` with what the last page gave as `next`.
#include "runner/queries/queries.hpp"
#include "runner/web/message.hpp"

namespace capstan {

struct PageQuery {
  PageRequest wanted;
  CaseFilter rest;  ///< the parameters that are not of the page
  Issues issues;
  std::string list;  ///< names the list by path and filter: the cursor of another one is refused
};

/// The parameters have been checked.
PageQuery read_page_query(const Request& request);

/// Adds `next`, a cursor, or null on the last page.
nlohmann::ordered_json with_next(nlohmann::ordered_json answer, const Page& page, const PageQuery& asked);

}  // namespace capstan
