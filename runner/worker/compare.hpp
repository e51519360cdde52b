#pragma once
// Two methods that share nothing but the membrane: what `capstan compare` does.
#include <filesystem>
#include <vector>

namespace capstan {

/// Runs each case in Stokes flow by boundary integrals, and on lattices whose spacing is halved twice and
/// whose box is doubled twice; prints a table for each, and how far the lattice is from Stokes flow in the
/// limit of no spacing and no walls. Faults go to standard error. \return the exit code of
/// schema/exit_codes.md
int compare_models(const std::vector<std::filesystem::path>& case_files, bool json);

}  // namespace capstan
