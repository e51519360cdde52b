#pragma once
// Functions that make the ParameterValue of a row of the table of parameters from a member of Case.
#include <memory>
#include <string>
#include <utility>

#include "solver/case/parameter_value.hpp"

namespace capstan {

using Value = std::shared_ptr<const ParameterValue>;

template <class T>
Place<T> place_of(T Case::*member) {
  return [member](Case& c) { return &(c.*member); };
}

template <class Group, class T>
Place<T> place_of(Group Case::*group, T Group::*member) {
  return [group, member](Case& c) { return &(c.*group.*member); };
}

/// A number with the same range in all cases.
/// \param member  a member of Case; or a group in Case and a member of this group
template <class... Member>
Value number(const Range& range, Member... member) {
  return std::make_shared<NumberValue>(Place<double>(place_of(member...)), range);
}

template <class... Member>
Value boolean(Member... member) {
  return std::make_shared<BooleanValue>(Place<bool>(place_of(member...)));
}

/// A value with one word for each enumerator.
/// \param also  a further word, which leaves the choice to the solver
template <HasWords Enum>
Value word(Place<Enum> place, std::string also = "") {
  constexpr auto kNames = words_of<Enum>();
  return std::make_shared<WordValue>(
      std::vector<std::string>(kNames.begin(), kNames.end()),
      [place](Case& c, std::string_view given) { *place(c) = *parse_word<Enum>(given); },
      [place](const Case& c) { return to_string(*place(const_cast<Case&>(c))); }, std::move(also));
}

}  // namespace capstan
