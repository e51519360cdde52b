#pragma once
// The keys "confirmed" and "error" of result.json (schema/run_directory.md).
#include <nlohmann/json.hpp>
#include <optional>

#include "solver/output/finished_run.hpp"

namespace capstan {

/// The estimated error of Q; nothing if one of the runs has no answer.
std::optional<double> estimate_of(const FinishedRun& run, const FinishedRun& companion);

/// \param run, companion  at a rung of the ladder and at a coarser one
nlohmann::ordered_json accuracy(const FinishedRun& run, const FinishedRun& companion);

/// For a run without a companion. \param reason  in words
nlohmann::ordered_json unknown_accuracy(const std::string& reason);

}  // namespace capstan
