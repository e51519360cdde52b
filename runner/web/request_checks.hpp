#pragma once
// Checks of every route: unknown query parameters and body keys are refused instead of ignored.
#include <httplib.h>

#include <span>
#include <string>
#include <string_view>

#include "runner/web/query_parameters.hpp"
#include "solver/case/parse.hpp"

namespace capstan {

/// Issues for parameters that are unknown, given twice, empty or invalid. `pointer` is the name of the
/// parameter.
Issues check_query(std::span<const QueryParameter> known, const httplib::Params& query);

/// Issues of a body that is neither empty nor a JSON object with no other keys than these.
Issues check_body(std::span<const std::string_view> keys, const std::string& body);

}  // namespace capstan
