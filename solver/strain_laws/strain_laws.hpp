#pragma once
// The table of strain laws. How to add a law: write its file in this folder, after the pattern of skalak.cpp,
// and its row in strain_laws.def. Case files, JSON schema, HTTP API and the tests of all laws take it from
// the table.
#include <string>
#include <string_view>
#include <vector>

namespace capstan {

struct StrainLaw;

/// All laws, in the order of the table; the first is the default.
const std::vector<StrainLaw>& strain_laws();

const StrainLaw* default_strain_law();

/// The law that case files call by this name; nullptr if there is none.
const StrainLaw* find_strain_law(std::string_view name);

/// The names of all laws, in the order of the table.
std::vector<std::string_view> strain_law_names();

}  // namespace capstan
