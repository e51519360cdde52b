#pragma once
// Compares two flow models that share only the membrane.
#include <filesystem>
#include <vector>

namespace capstan {

/// `capstan compare`: runs each case with boundary integrals, then with the quasisteady lattice at three
/// spacings and in three boxes. Prints D_xy and theta at the end of each run, and the lattice's values
/// extrapolated to no spacing and no walls. Prints issues to standard error. Returns the exit code
/// (schema/exit_codes.md): kExitNoAnswer if a run does not reach its end.
int compare_models(const std::vector<std::filesystem::path>& case_files, bool json);

}  // namespace capstan
