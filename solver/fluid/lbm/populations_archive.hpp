#pragma once
// Populations to and from a checkpoint: one entry a direction.
#include <algorithm>
#include <string>

#include "solver/fluid/lbm/population_field.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

inline void put_populations(StateArchive& archive, const std::string& name, const PopulationField& f) {
  for (int q = 0; q < d3q19::kQ; ++q) archive.put_view(name + std::to_string(q), f[q].data());
}

/// Throws std::runtime_error when the entry is missing or has another size.
inline void get_populations(const StateArchive& archive, const std::string& name, PopulationField& f) {
  for (int q = 0; q < d3q19::kQ; ++q) {
    const auto data = archive.get(name + std::to_string(q));
    if (data.size() != f[q].data().size())
      throw std::runtime_error("checkpoint entry \"" + name + "\" has another grid");
    std::ranges::copy(data, f[q].data().begin());
  }
}

}  // namespace capstan
