#pragma once
// The times kt of records or shapes: 0, interval, 2 interval, .. and the end of the run.
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace capstan {

class OutputTimes {
 public:
  OutputTimes(double interval, double end)
      : interval_(interval), end_(end), last_(long(std::ceil(end / interval * (1 - 1e-12)))) {}

  long last() const { return last_; }  ///< number of the last time; the start has number 0

  /// The time with this number, rounded to 15 significant digits: 3 times 0.1 is 0.3, not
  /// 0.30000000000000004. The rounding error of the product is less than half a unit of the fifteenth digit.
  double operator[](long number) const {
    if (number >= last_) return end_;
    char text[32];
    std::snprintf(text, sizeof text, "%.15g", double(number) * interval_);
    return std::strtod(text, nullptr);
  }

 private:
  double interval_, end_;
  long last_;
};

}  // namespace capstan
