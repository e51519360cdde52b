#pragma once
// Keys without effect at a study's points. Where a key has an effect at another point it is dropped here;
// where it has one at no point it is a fault.
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
  /// Which value of which axis: "axis 1, value 3".
  using AxisValue = std::pair<std::size_t, std::size_t>;

  /// A point whose case is read, with the values that stand there of axes that are lists.
  void count_point(const std::vector<AxisValue>& values);

  /// A key that was taken out of that case.
  /// \param pointer  where it stands in the study  \param axis  the value of an axis that it stands in, if
  /// any
  void add(const Issue& issue, const std::string& pointer, const std::optional<AxisValue>& axis);

  /// The keys that have an effect at no point where they stand, with pointers into the study.
  Issues faults() const;

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
