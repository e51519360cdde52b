#pragma once
// Metrics of the queue for monitoring.
#include <string>

#include "runner/store/database.hpp"

namespace capstan {

/// The two lines of Prometheus' text format that describe a metric.
/// \param type  "counter" or "gauge"
std::string metric_description(const std::string& name, const std::string& type, const std::string& help);

/// Prometheus text format. No ids among the labels: their number would grow without bound.
std::string metrics_text(Database& database, std::size_t cores);

}  // namespace capstan
