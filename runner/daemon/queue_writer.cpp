#include "runner/daemon/queue_writer.hpp"

namespace capstan {

void QueueWriter::report_damage(const std::string& what) {
  const std::lock_guard lock(damage_mutex_);
  damage_ = what;
}

void QueueWriter::expect_sound() const {
  {
    const std::lock_guard lock(damage_mutex_);
    if (!damage_.empty()) throw DatabaseDamaged(damage_);
  }
  database.expect_in_place();
}

}  // namespace capstan
