#include "solver/case/json_text.hpp"

#include <set>

namespace capstan {
namespace {

using nlohmann::json;

/// Checked before parsing: nlohmann::json recurses when it destroys a value, and a deep one exhausts the
/// stack.
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

/// Finds keys that occur twice in an object. A SAX parser is used because the time of json::parse with a
/// callback grows with the square of the number of objects in an array.
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
  std::vector<std::set<std::string>> keys_;  ///< keys of each object around the current position
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

}  // namespace capstan
