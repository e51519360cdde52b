#include "solver/coupling/cell_box.hpp"

#include <cmath>

namespace capstan {

double relative_difference(const VectorBox& u, const VectorBox& v) {
  const std::size_t cells = u.values().size() / 3;
  const auto length = [&](auto component) {
    return std::sqrt(std::pow(component(0), 2) + std::pow(component(1), 2) + std::pow(component(2), 2));
  };
  double change = 0, size = 0;
  for (std::size_t i = 0; i < cells; ++i) {
    change += length([&](int c) { return u.values()[c * cells + i] - v.values()[c * cells + i]; });
    size += length([&](int c) { return u.values()[c * cells + i]; });
  }
  return change / size;
}

}  // namespace capstan
