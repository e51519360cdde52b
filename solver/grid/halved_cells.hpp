#pragma once
#include <vector>

namespace capstan {

/// Numbers of cells along an edge of grids that cover the same domain, each of twice the spacing of the one
/// before: `finest` is halved until the number is at most 8 or its half would be odd.
inline std::vector<int> halved_cells(int finest) {
  std::vector<int> cells = {finest};
  while (cells.back() > 8 && cells.back() % 4 == 0) cells.push_back(cells.back() / 2);
  return cells;
}

}  // namespace capstan
