#pragma once

namespace capstan {

/// Enters a mount namespace: from now on only this process and its children see its mounts. A user who is not
/// root enters a user namespace, too. Returns false if neither is allowed.
bool enter_mount_namespace();

}  // namespace capstan
