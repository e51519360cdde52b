#include "runner/boundary/next_corners.hpp"

#include <optional>
#include <set>

#include "solver/case/significant_digits.hpp"

namespace capstan {
namespace {

struct Cell {
  Corner low, high;

  std::array<Corner, 4> corners() const { return {low, {high[0], low[1]}, {low[0], high[1]}, high}; }
};

class Refinement {
 public:
  explicit Refinement(const RefinedGrid& grid) : grid_(grid) {}

  std::vector<Corner> next() {
    for (std::size_t i = 0; i + 1 < grid_.values[0].size(); ++i)
      for (std::size_t j = 0; j + 1 < grid_.values[1].size(); ++j)
        visit({{grid_.values[0][i], grid_.values[1][j]}, {grid_.values[0][i + 1], grid_.values[1][j + 1]}});
    return {missing_.begin(), missing_.end()};
  }

 private:
  /// Divides the cell if it is to be divided: asks for the corners of its parts, or visits these.
  void visit(const Cell& cell) {
    const std::vector<Cell> parts = parts_of(cell);
    if (parts.size() == 1 || !changes_in(cell)) return;
    const std::size_t before = missing_.size();
    for (const Cell& part : parts)
      for (const Corner& corner : part.corners())
        if (!grid_.points.contains(corner)) missing_.insert(corner);
    if (missing_.size() == before)
      for (const Cell& part : parts) visit(part);
  }

  /// Whether all corners have ended, and two of them have different labels.
  bool changes_in(const Cell& cell) const {
    std::set<Motion> labels;
    for (const Corner& corner : cell.corners()) {
      const auto point = grid_.points.find(corner);
      if (point == grid_.points.end() || !point->second.has_ended) return false;
      if (point->second.motion) labels.insert(*point->second.motion);
    }
    return labels.size() > 1;
  }

  /// The cell in halves along each side that is too long.
  std::vector<Cell> parts_of(const Cell& cell) const {
    std::vector<Cell> parts = {cell};
    for (std::size_t side = 0; side < 2; ++side) {
      constexpr double kRounding = 1e-9;
      const double length = cell.high[side] - cell.low[side];
      if (length <= grid_.sides[side] * (1 + kRounding)) continue;
      constexpr int kDigits = 12;  // 0.3625, not 0.36250000000000004
      const double middle = with_significant_digits((cell.low[side] + cell.high[side]) / 2, kDigits);
      std::vector<Cell> halves;
      for (const Cell& part : parts) {
        halves.push_back(part);
        halves.back().high[side] = middle;
        halves.push_back(part);
        halves.back().low[side] = middle;
      }
      parts = halves;
    }
    return parts;
  }

  const RefinedGrid& grid_;
  std::set<Corner> missing_;
};

}  // namespace

std::vector<Corner> next_corners(const RefinedGrid& grid) { return Refinement(grid).next(); }

}  // namespace capstan
