#pragma once
// The queue in numbers, for monitoring.
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// Prometheus text: base units, totals end in `_total`, no ids among the labels.
std::string metrics_text(Database& database, std::size_t cores);

}  // namespace capstan
