#pragma once
// Time limits as Slurm writes them.
#include <chrono>
#include <optional>
#include <string>

namespace capstan {

/// Reads "90", "90:00", "1:30:00", "1-12", "1-12:00" or "1-12:00:00" (minutes first, as sbatch --time);
/// seconds are rounded up. Nothing if the text has another form or is 0.
std::optional<std::chrono::minutes> parse_time_limit(const std::string& text);

}  // namespace capstan
