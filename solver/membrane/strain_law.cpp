#include "solver/membrane/strain_law.hpp"

#include "solver/membrane/neo_hookean.hpp"
#include "solver/membrane/skalak.hpp"

namespace capstan {

std::unique_ptr<StrainLaw> make_strain_law(const Case& c) {
  if (c.law == Law::skalak) return std::make_unique<Skalak>(c.C);
  return std::make_unique<NeoHookean>();
}

}  // namespace capstan
