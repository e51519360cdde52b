#pragma once
// Metrics of the queue for monitoring.
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// Prometheus text format. No ids among the labels: their number would grow without bound.
std::string metrics_text(Database& database, std::size_t cores);

}  // namespace capstan
