#pragma once

namespace capstan {

/// From now on mounts of this process are seen by its children alone. A user without rights has them in a
/// namespace of its own. False where neither can be had.
bool keep_mounts_to_oneself();

}  // namespace capstan
