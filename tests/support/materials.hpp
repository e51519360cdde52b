#pragma once
// Strain laws with values of their constants, for tests of all laws of the table.
#include <algorithm>
#include <cctype>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "solver/strain_laws/strain_law.hpp"
#include "solver/strain_laws/strain_laws.hpp"

namespace capstan::testing {

struct Material {
  const StrainLaw* law;
  LawConstants constants;
};

inline std::ostream& operator<<(std::ostream& stream, const Material& material) {
  stream << material.law->name;
  for (const double constant : material.constants) stream << ' ' << constant;
  return stream;
}

/// "skalak_5" for names of tests.
inline std::string name_of(const Material& material) {
  std::ostringstream name;
  name << material;
  std::string text = name.str();
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return text;
}

/// The law of that name. All its constants have the value, or the nearest that they may have.
inline Material material(const StrainLaw& law, double value) {
  LawConstants constants;
  constants.reserve(law.constants.size());
  for (const LawConstant& constant : law.constants)
    constants.push_back(std::clamp(value, constant.min, constant.max));
  return {&law, constants};
}

/// Every law of the table: with small constants, and with those of a membrane that resists dilation.
inline std::vector<Material> all_materials() {
  std::vector<Material> all;
  for (const StrainLaw& law : strain_laws())
    for (const double value : {0., 5.})
      if (value == 0 || !law.constants.empty()) all.push_back(material(law, value));
  return all;
}

}  // namespace capstan::testing
