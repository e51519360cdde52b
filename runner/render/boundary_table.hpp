#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "runner/render/table.hpp"

namespace capstan {

/// The crossings of a boundary, one a row. \param boundary  as find_boundary returns it
Table boundary_table(const nlohmann::ordered_json& boundary);

/// The table with sentences: the rows without a crossing, how the search goes on, and what it covers.
std::string boundary_text(const nlohmann::ordered_json& boundary);

}  // namespace capstan
