#include "solver/strain_laws/strain_laws.hpp"

#include "solver/strain_laws/strain_law.hpp"

namespace capstan {

#define STRAIN_LAW(law) StrainLaw law();
#include "solver/strain_laws/strain_laws.def"
#undef STRAIN_LAW

const std::vector<StrainLaw>& strain_laws() {
  static const std::vector<StrainLaw> laws = {
#define STRAIN_LAW(law) law(),
#include "solver/strain_laws/strain_laws.def"
#undef STRAIN_LAW
  };
  return laws;
}

const StrainLaw* default_strain_law() { return &strain_laws().front(); }

const StrainLaw* find_strain_law(std::string_view name) {
  for (const StrainLaw& law : strain_laws())
    if (law.name == name) return &law;
  return nullptr;
}

std::vector<std::string_view> strain_law_names() {
  std::vector<std::string_view> names;
  names.reserve(strain_laws().size());
  for (const StrainLaw& law : strain_laws()) names.push_back(law.name);
  return names;
}

}  // namespace capstan
