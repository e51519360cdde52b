#pragma once
// Work that is done now and then and shall take at most a fiftieth of a run's time, whatever it costs.
#include <algorithm>

namespace capstan {

class ShareOfTime {
 public:
  /// \param now  seconds, by any clock that never goes back   \param interval  the least from one time to the
  /// next
  bool is_due(double now, double interval) const {
    return now - done_ >= std::max(interval, kRestToWork * last_cost_);
  }

  void done(double began, double ended) {
    done_ = ended;
    last_cost_ = ended - began;
  }

 private:
  static constexpr double kRestToWork = 50;
  double done_ = 0, last_cost_ = 0;
};

}  // namespace capstan
