#pragma once
// The times kt of records or shapes: 0, interval, 2 interval, ..
#include <cstdio>
#include <cstdlib>

namespace capstan {

class OutputTimes {
 public:
  explicit OutputTimes(double interval) : interval_(interval) {}

  /// The time with this number, rounded to 15 significant digits: 3 times 0.1 is 0.3, not
  /// 0.30000000000000004. The rounding error of the product is less than half a unit of the fifteenth digit.
  double operator[](long number) const {
    char text[32];
    std::snprintf(text, sizeof text, "%.15g", double(number) * interval_);
    return std::strtod(text, nullptr);
  }

 private:
  double interval_;
};

}  // namespace capstan
