#pragma once
// Populations to and from a checkpoint: one entry for each direction, with the ghost cells, x fastest.
#include <algorithm>
#include <string>

#include "solver/fluid/lbm/d3q19.hpp"
#include "solver/grid/row_field.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

inline void put_populations(StateArchive& archive, const std::string& name, const RowField<double>& f) {
  const IndexBox with_ghosts = grown(f.box(), 1);
  for (int q = 0; q < d3q19::kQ; ++q) {
    std::vector<double> numbers;
    numbers.reserve(std::size_t(with_ghosts.cells()));
    for_each_row_in_order(with_ghosts, [&](int y, int z) {
      const double* first = f.row(q, y, z) - 1;
      numbers.insert(numbers.end(), first, first + with_ghosts.size(0));
    });
    archive.put(name + std::to_string(q), std::move(numbers));
  }
}

/// Throws std::runtime_error if an entry is missing or has another size.
inline void get_populations(const StateArchive& archive, const std::string& name, RowField<double>& f) {
  const IndexBox with_ghosts = grown(f.box(), 1);
  for (int q = 0; q < d3q19::kQ; ++q) {
    const auto numbers = archive.get(name + std::to_string(q));
    if (long(numbers.size()) != with_ghosts.cells())
      throw std::runtime_error("checkpoint entry \"" + name + "\" has another grid");
    auto next = numbers.begin();
    for_each_row_in_order(with_ghosts, [&](int y, int z) {
      std::copy_n(next, with_ghosts.size(0), f.row(q, y, z) - 1);
      next += with_ghosts.size(0);
    });
  }
}

}  // namespace capstan
