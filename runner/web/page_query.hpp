#pragma once
// Lists are returned in pages: `?limit=100` bounds a page, `?after=` continues after the page that returned
// this cursor as `next`.
#include <httplib.h>

#include "runner/queries/queries.hpp"

namespace capstan {

struct PageQuery {
  PageRequest wanted;
  CaseFilter rest;  ///< the other parameters
  Issues issues;
  std::string list;  ///< identifies path and filter, so that the cursor of another list is refused
};

/// \param request  with parameters that the route accepts
PageQuery read_page_query(const httplib::Request& request);

/// Adds `next`: a cursor, or null on the last page.
nlohmann::ordered_json with_next(nlohmann::ordered_json answer, const Page& page, const PageQuery& asked);

}  // namespace capstan
