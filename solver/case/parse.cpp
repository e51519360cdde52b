#include "solver/case/parse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "solver/case/choose_fluid.hpp"
#include "solver/case/limits.hpp"
#include "solver/case/mistyped_keys.hpp"
#include "solver/case/nearest_word.hpp"
#include "solver/case/shown_number.hpp"
#include "solver/case/time_step_defaults.hpp"
#include "solver/grid/halved_cells.hpp"

namespace capstan {
namespace {

using nlohmann::json;

struct Range {
  double low, high;
  bool low_is_open = false;
  const char* of = "";  ///< whose bounds they are, where that depends on another key
};

/// Takes keys out of one JSON object, collecting what is wrong with them; `finish` reports the keys left
/// over.
class ObjectReader {
 public:
  ObjectReader(const json& object, std::string pointer, Issues& issues)
      : object_(object), pointer_(std::move(pointer)), issues_(issues) {}

  bool has(const char* key) const { return object_.contains(key); }

  void fault(const char* key, std::string message) {
    issues_.push_back({pointer_ + "/" + key, std::move(message)});
  }

  const json* take(const char* key) {
    known_.insert(key);
    const auto found = object_.find(key);
    return found == object_.end() ? nullptr : &*found;
  }

  void number(const char* key, double& value, Range range) {
    const json* found = take(key);
    if (!found) return;
    if (!found->is_number()) return fault(key, std::string("must be a number, is ") + found->type_name());
    const double given = found->get<double>();
    const bool too_low = range.low_is_open ? !(given > range.low) : !(given >= range.low);
    if (!std::isfinite(given) || too_low || given > range.high)
      return fault(key, "is " + shown(given) + ", must be " + (range.low_is_open ? "> " : ">= ") +
                            shown(range.low) + " and <= " + shown(range.high) + range.of);
    value = given + 0.0;  // -0.0 is 0
  }

  void integer(const char* key, int& value, Range range) {
    const json* found = take(key);
    if (!found) return;
    double number_value = value;
    const size_t before = issues_.size();
    number(key, number_value, range);
    if (issues_.size() > before) return;
    if (number_value != std::floor(number_value)) return fault(key, "must be a whole number");
    value = static_cast<int>(number_value);
  }

  void boolean(const char* key, bool& value) {
    const json* found = take(key);
    if (!found) return;
    if (!found->is_boolean())
      return fault(key, std::string("must be true or false, is ") + found->type_name());
    value = found->get<bool>();
  }

  /// One of the words of an enumeration. `also` is a word that the caller deals with itself.
  template <class Enum, size_t N>
  void choice(const char* key, Enum& value, const std::array<Enum, N>& choices, std::string_view also = {}) {
    const json* found = take(key);
    if (!found) return;
    std::vector<std::string> words;
    for (Enum option : choices) words.emplace_back(to_string(option));
    if (!also.empty()) words.emplace_back(also);
    const std::string meant = is_one_of(key, *found, words);
    for (Enum option : choices)
      if (meant == to_string(option)) value = option;
  }

  /// The word, or a fault and the nearest of the words, if one is near.
  std::string is_one_of(const char* key, const json& found, const std::vector<std::string>& words) {
    const std::string given = found.is_string() ? found.get<std::string>() : "";
    if (std::find(words.begin(), words.end(), given) != words.end()) return given;
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    fault(key, "must be one of: " + list + "; is " +
                   found.dump(-1, ' ', false, json::error_handler_t::replace) + suggestion(given, words));
    return nearest_word(given, words).value_or("");
  }

  /// What depends on a value that is wrong is no fault of its own.
  bool is_faulty(const char* key) const {
    const auto stands_there = [&](const Issue& issue) { return issue.pointer == pointer_ + "/" + key; };
    return std::any_of(issues_.begin(), issues_.end(), stands_there);
  }

  /// A key that is only meaningful under a condition.
  void without_effect(const char* key, bool effective, const char* why) {
    if (effective || !has(key)) return;
    issues_.push_back({pointer_ + "/" + key, std::string("has no effect: ") + why, true});
  }

  /// A reader for the object under `key`, if it is there and is one.
  std::optional<ObjectReader> nested(const char* key) {
    const json* found = take(key);
    if (!found) return std::nullopt;
    if (!found->is_object()) {
      fault(key, std::string("must be an object, is ") + found->type_name());
      return std::nullopt;
    }
    return ObjectReader(*found, pointer_ + "/" + key, issues_);
  }

  void finish() {
    for (const auto& [key, value] : object_.items())
      if (!known_.contains(key))
        issues_.push_back({(json::json_pointer(pointer_) / key).to_string(),
                           "unknown key" + suggestion(key, missing_keys())});
  }

 private:
  std::vector<std::string> missing_keys() const {
    std::vector<std::string> missing;
    for (const std::string& key : known_)
      if (!object_.contains(key)) missing.push_back(key);
    return missing;
  }

  const json& object_;
  std::string pointer_;
  Issues& issues_;
  std::set<std::string> known_;
};

void read_shape(ObjectReader& reader, Case& c) {
  reader.choice("shape", c.shape, std::array{Shape::sphere, Shape::oblate, Shape::prolate, Shape::biconcave});
  const bool spheroid = c.shape == Shape::oblate || c.shape == Shape::prolate;
  reader.without_effect("aspect", spheroid || reader.is_faulty("shape"),
                        "only oblate and prolate shapes have an aspect");
  if (!spheroid) {
    reader.take("aspect");
  } else if (!reader.has("aspect")) {
    if (!reader.is_faulty("shape"))
      reader.fault("aspect", "is missing: the axis of revolution over the equatorial axis (b/a)");
  } else if (c.shape == Shape::oblate) {
    reader.number("aspect", c.aspect, {0.1, 1, false, " for an oblate shape"});
  } else {
    reader.number("aspect", c.aspect, {1, 5, false, " for a prolate shape"});
  }
}

void read_membrane(ObjectReader& reader, Case& c) {
  reader.choice("law", c.law, std::array{Law::neo_hookean, Law::skalak});
  const bool law_is_known = !reader.is_faulty("law");
  reader.without_effect("C", c.law == Law::skalak || !law_is_known, "only the skalak law has the constant C");
  if (c.law == Law::skalak) {
    if (!reader.has("C") && law_is_known)
      reader.fault("C", "is missing: Skalak's resistance to area dilation");
    reader.number("C", c.C, {0, 1000});
  }
  reader.take("C");
  if (!reader.has("Ca")) reader.fault("Ca", "is missing: the capillary number");
  reader.number("Ca", c.Ca, {1e-4, 100});
  reader.number("E_b", c.E_b, {0, 10});
  for (const char* key : {"bending", "c0"})
    reader.without_effect(key, c.has_bending() || reader.is_faulty("E_b"),
                          "E_b is 0, so there is no bending resistance");
  reader.choice("bending", c.bending, std::array{BendingModel::variational, BendingModel::helfrich_literal});
  const json* c0 = reader.take("c0");
  if (c0 && c0->is_number()) {
    double number = 0;
    reader.number("c0", number, {-100, 100});
    c.c0 = number;
  } else if (c0 && *c0 == "uniform") {
    c.c0 = UniformCurvature{};
  } else if (c0 && *c0 != "initial") {
    reader.fault("c0", "must be a number (in units of 1/a), \"initial\" or \"uniform\"" +
                           suggestion(c0->is_string() ? c0->get<std::string>() : "", {"initial", "uniform"}));
  }
}

void read_fluid(ObjectReader& reader, Case& c, Choices& choices) {
  const json *given = reader.take("fluid"), *fidelity = reader.take("fidelity");
  const json asked = given ? *given : json("auto");
  const FluidChoice choice = choose_fluid(c.Re, fidelity ? *fidelity : json());
  c.fluid = choice.fluid;
  if (asked == "auto")
    choices.push_back({"fluid", asked, to_string(c.fluid), choice.reason});
  else
    reader.choice("fluid", c.fluid, std::array{Fluid::quasisteady, Fluid::transient, Fluid::stokes}, "auto");
}

void leave_out_inertia(ObjectReader& reader, Case& c, Choices& choices) {
  if (c.Re > kMaxStokesRe)
    reader.fault("Re", "is " + shown(c.Re) +
                           ", but the fluid \"stokes\" has no inertia: at most 0.1, or another fluid");
  if (c.Re > 0 && reader.has("Re")) choices.push_back({"Re", c.Re, 0, "boundary integrals have no inertia"});
  c.Re = 0;
}

void read_flow(ObjectReader& reader, Case& c, Choices& choices) {
  reader.number("V", c.V, {0.01, 100});
  c.Re = 0.05;
  reader.number("Re", c.Re, {0, 10});
  read_fluid(reader, c, choices);
  if (!c.has_grid()) return leave_out_inertia(reader, c, choices);
  if (c.Re == 0)
    reader.fault("Re",
                 "is 0, which a lattice cannot have; give Re > 0, or leave out what asks for a lattice");
}

void read_until(ObjectReader& reader, Until& until) {
  auto inner = reader.nested("until");
  if (!inner) return;
  inner->number("kt", until.kt, {kMinTime, 10000});
  inner->boolean("classified", until.classified);
  inner->finish();
}

void read_outputs(ObjectReader& reader, Outputs& outputs) {
  auto inner = reader.nested("outputs");
  if (!inner) return;
  inner->number("history_every", outputs.history_every, {kMinTime, 1});
  inner->number("shapes_every", outputs.shapes_every, {0, 10000});
  if (outputs.shapes_every > 0 && outputs.shapes_every < kMinTime)
    inner->fault("shapes_every", "is " + shown(outputs.shapes_every) +
                                     ", must be 0 (no shapes) or at least " + shown(kMinTime));
  inner->integer("checkpoint_every", outputs.checkpoint_every, {0, 1000000});
  inner->finish();
}

/// Of a preset boundary integrals take the mesh alone.
Fidelity preset_for(const Case& c, const FidelityPreset& preset) {
  if (c.has_grid()) return preset.knobs;
  Fidelity fidelity;
  fidelity.nodes = preset.knobs.nodes;
  fidelity.stepper = Stepper::runge_kutta_chebyshev;
  return fidelity;
}

/// The preset's knobs, if `name` is one.
void start_from_preset(ObjectReader& reader, const char* key, const json& name, const Case& c,
                       Fidelity& fidelity) {
  std::vector<std::string> names;
  for (const FidelityPreset& preset : fidelity_presets()) names.emplace_back(preset.name);
  if (const FidelityPreset* preset = find_preset(reader.is_one_of(key, name, names)))
    fidelity = preset_for(c, *preset);
}

/// \param may_have_contrast  also where V is faulty
void read_knobs(ObjectReader& knobs, const Case& c, bool may_have_contrast, Fidelity& fidelity) {
  if (const json* name = knobs.take("preset")) start_from_preset(knobs, "preset", *name, c, fidelity);
  knobs.number("dx", fidelity.dx, {0.02, 0.5});
  knobs.number("box", fidelity.box, {4, 100});
  knobs.integer("nodes", fidelity.nodes, {12, 40962});
  if (!icosphere_subdivisions(fidelity.nodes))
    knobs.fault("nodes", "must be 12, 42, 162, 642, 2562, 10242 or 40962 (a subdivided icosahedron)");
  knobs.choice("scheme", fidelity.scheme, std::array{Scheme::tuned, Scheme::paper});
  knobs.choice("symmetry", fidelity.symmetry, std::array{Symmetry::automatic, Symmetry::none});
  knobs.choice("precision", fidelity.precision, std::array{Precision::single, Precision::double_});
  knobs.choice("stepper", fidelity.stepper,
               std::array{Stepper::adams_bashforth, Stepper::runge_kutta_chebyshev});
  knobs.number("tolerance", fidelity.tolerance, {1e-12, 0.1});
  for (const char* key : {"scheme", "stepper", "tolerance", "kdt"})
    knobs.without_effect(key, c.fluid != Fluid::transient,
                         "the transient flow's time step is set by the lattice");
  knobs.without_effect("tolerance", c.fluid != Fluid::stokes || may_have_contrast,
                       "at V = 1 boundary integrals give the flow without solving an equation");
  for (const char* key : {"dx", "box", "scheme"})
    knobs.without_effect(key, c.has_grid(), "boundary integrals have no grid");
  knobs.without_effect("symmetry", c.can_use_symmetry(), "this flow is always solved for as a whole");
  knobs.without_effect("precision", c.has_composite_grid() || c.fluid == Fluid::transient,
                       "only the quasi-steady flow's tuned scheme and the transient flow have a choice");
  knobs.without_effect("kdt", fidelity.stepper == Stepper::adams_bashforth,
                       "rkc2 chooses its steps by their error");
}

/// \param knobs null where none were given
void choose_time_step(ObjectReader* knobs, Case& c) {
  Fidelity& fidelity = c.fidelity;
  const bool is_open = !knobs || (!knobs->has("stepper") && !knobs->has("kdt"));
  if (is_open && c.fluid == Fluid::quasisteady) fidelity.stepper = default_stepper(c);
  fidelity.kdt = fidelity.stepper == Stepper::adams_bashforth ? default_kdt(c) : 0;
  if (knobs) knobs->number("kdt", fidelity.kdt, {kMinTime, 1});
}

void check_grid(ObjectReader& reader, const Case& c) {
  constexpr int kMaxCoarsestSweeps = 24;
  const Fidelity& fidelity = c.fidelity;
  const double cells = fidelity.box / fidelity.dx;
  if (std::abs(cells - std::round(cells)) > 1e-9 * cells || std::lround(cells) % 8 != 0)
    reader.fault("fidelity",
                 "box/dx is " + shown(cells) + ", must be a multiple of 8 so that the grid can be coarsened");
  else if (c.has_composite_grid() && halved_cells(int(std::lround(cells))).back() > kMaxCoarsestSweeps)
    reader.fault("fidelity", "box/dx is " + shown(cells) +
                                 ", which cannot be halved until 24 or less are left; try " +
                                 shown(std::exp2(std::round(std::log2(cells)))));
}

void read_fidelity(ObjectReader& reader, Case& c) {
  const json* given = reader.take("fidelity");
  Fidelity& fidelity = c.fidelity;
  fidelity = preset_for(c, *find_preset("standard"));
  std::optional<ObjectReader> knobs;
  if (given && given->is_object()) {
    knobs.emplace(*reader.nested("fidelity"));
    read_knobs(*knobs, c, c.has_viscosity_ratio() || reader.is_faulty("V"), fidelity);
  } else if (given) {
    start_from_preset(reader, "fidelity", *given, c, fidelity);
  }
  choose_time_step(knobs ? &*knobs : nullptr, c);
  if (knobs) knobs->finish();
  if (c.has_grid()) check_grid(reader, c);
}

/// A key that has no effect is one fault, whatever its value.
void leave_out_faults_of_keys_without_effect(Issues& issues) {
  std::set<std::string> useless;
  for (const Issue& issue : issues)
    if (issue.without_effect) useless.insert(issue.pointer);
  std::erase_if(issues,
                [&](const Issue& issue) { return !issue.without_effect && useless.contains(issue.pointer); });
}

}  // namespace

ParsedCase parse_case(const json& object) {
  ParsedCase parsed;
  if (!object.is_object()) {
    parsed.issues.push_back({"", std::string("a case must be an object, is ") + object.type_name()});
    return parsed;
  }
  json corrected = object;
  parsed.issues = rename_mistyped_keys(corrected, case_keys());
  Case c;
  ObjectReader reader(corrected, "", parsed.issues);
  read_shape(reader, c);
  read_membrane(reader, c);
  read_flow(reader, c, parsed.choices);
  read_until(reader, c.until);
  read_outputs(reader, c.outputs);
  read_fidelity(reader, c);
  reader.finish();
  leave_out_faults_of_keys_without_effect(parsed.issues);
  if (parsed.issues.empty()) parsed.issues = limits_exceeded(c);
  if (parsed.issues.empty()) parsed.value = c;
  return parsed;
}

Issues drop_keys_without_effect(json& object) {
  Issues dropped;
  for (const Issue& issue : parse_case(object).issues) {
    if (!issue.without_effect) continue;
    const json::json_pointer key(issue.pointer);
    object[key.parent_pointer()].erase(key.back());
    dropped.push_back(issue);
  }
  return dropped;
}

namespace {

/// The library recurses when a value is destroyed, so a deep text is refused before it is parsed.
bool nested_deeper_than(int limit, std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const char ch = text[i];
    if (in_string) {
      if (ch == '\\')
        ++i;
      else if (ch == '"')
        in_string = false;
    } else if (ch == '"') {
      in_string = true;
    } else if (ch == '[' || ch == '{') {
      if (++depth > limit) return true;
    } else if (ch == ']' || ch == '}') {
      --depth;
    }
  }
  return false;
}

/// Looks for keys that stand twice in one object; nlohmann's own check by a callback of json::parse takes
/// time that grows with the square of the number of objects in one array.
class DuplicateKeys : public nlohmann::json_sax<json> {
 public:
  explicit DuplicateKeys(Issues& issues) : issues_(issues) {}

  bool start_object(std::size_t) override {
    keys_.emplace_back();
    return true;
  }
  bool key(string_t& name) override {
    if (!keys_.back().insert(name).second)
      issues_.push_back({"", "the key \"" + name + "\" stands twice in one object"});
    return true;
  }
  bool end_object() override {
    keys_.pop_back();
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const json::exception& error) override {
    issues_.push_back({"", std::string("not valid JSON: ") + error.what()});
    return false;
  }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }

 private:
  Issues& issues_;
  std::vector<std::set<std::string>> keys_;  ///< of the objects that are open
};

}  // namespace

ParsedJson parse_json(std::string_view text) {
  constexpr int kMaxDepth = 32;  // a study needs four
  ParsedJson parsed;
  if (nested_deeper_than(kMaxDepth, text)) {
    parsed.issues.push_back({"", "nested deeper than " + std::to_string(kMaxDepth) + " levels"});
    return parsed;
  }
  DuplicateKeys duplicates(parsed.issues);
  json::sax_parse(text.begin(), text.end(), &duplicates);
  if (parsed.issues.empty()) parsed.value = json::parse(text.begin(), text.end());
  return parsed;
}

const std::vector<std::string_view>& scalar_parameters() {
  static const std::vector<std::string_view> names = {"shape", "aspect", "law",     "C",  "Ca",   "V",
                                                      "Re",    "E_b",    "bending", "c0", "fluid"};
  return names;
}

}  // namespace capstan
