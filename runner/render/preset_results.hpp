#pragma once
// What the presets of fidelity cost and how far off they are, measured (studies/cross_validation).
#include <array>
#include <optional>
#include <string_view>

namespace capstan {

inline constexpr std::string_view kPresetScene =
    "red cell (Skalak, C = 5, E_b = 0.015), Ca = 0.25, V = 4, to kt = 10; distance of Q from boundary "
    "integrals "
    "at standard; the lattice has walls 25.6 apart";

struct PresetResult {
  std::string_view preset, fluid;
  double seconds;                 ///< processor time, one core
  std::optional<double> Q_error;  ///< largest |Q - Q'| from kt = 0.5 on; nothing for the reference
};

inline constexpr auto kPresetResults = std::to_array<PresetResult>({
    {"fast", "stokes", 0.11, 0.004},
    {"standard", "stokes", 1.5, std::nullopt},
    {"fast", "quasisteady", 0.37, 0.017},
    {"standard", "quasisteady", 0.94, 0.014},
});

}  // namespace capstan
