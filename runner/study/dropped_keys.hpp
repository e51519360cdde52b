#pragma once
// Keys without effect at some points of a study. A key that has an effect at another point is dropped where
// it has none; a key without effect at all points is an issue.
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solver/case/parse.hpp"

namespace capstan {

class DroppedKeys {
 public:
  /// Index of the axis, index of the value.
  using AxisValue = std::pair<std::size_t, std::size_t>;

  /// Counts a point whose case is checked for keys without effect.
  /// \param values  those of its values that come from a list
  void count_point(const std::vector<AxisValue>& values);

  /// Adds a key that was removed from the case of that point.
  /// \param pointer  of the key in the study
  /// \param axis     the axis value that contains the key, if one does
  void add(const Issue& issue, const std::string& pointer, const std::optional<AxisValue>& axis);

  /// The keys that have no effect at any point that has them, with pointers into the study.
  Issues issues() const;

  /// "C is dropped at 3 of 6 points, where it has no effect: ..."
  std::vector<std::string> notes() const;

 private:
  struct Dropped {
    Issue issue;
    std::size_t points = 0;
    std::optional<AxisValue> axis;
  };
  std::size_t points_where_it_stands(const Dropped& dropped) const;

  std::size_t points_ = 0;
  std::map<AxisValue, std::size_t> points_with_;
  std::map<std::string, Dropped> dropped_;  ///< by the pointer into the study
};

}  // namespace capstan
