#include "runner/cli/resolve.hpp"

#include <algorithm>
#include <cctype>

namespace capstan {
namespace {

using nlohmann::ordered_json;

/// Letters, digits, - and _: such text needs no encoding in a URL.
bool could_be_an_id(const std::string& typed) {
  constexpr std::size_t kMax = 120;
  const auto allowed = [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '-' || c == '_'); };
  return !typed.empty() && typed.size() <= kMax && std::all_of(typed.begin(), typed.end(), allowed);
}

ordered_json matches(Client& client, const std::string& typed) {
  if (could_be_an_id(typed)) return client.get("/v1/ids/" + typed);
  return {{"studies", ordered_json::array()}, {"cases", ordered_json::array()}};
}

[[noreturn]] void refuse_ambiguous(const std::string& typed, const std::vector<std::string>& found) {
  std::string text = "\"" + typed + "\" could be any of these:";
  for (const std::string& id : found) text += "\n  " + id;
  throw std::invalid_argument(text);
}

/// Returns the only match; throws if there is none or more than one.
/// \param kind  of the matches, for the message
std::string only_match(const std::string& kind, const std::string& typed,
                       const std::vector<std::string>& found) {
  if (found.empty())
    throw Refused(404, "there is no " + kind + " \"" + typed + "\"; capstan studies lists the studies", {});
  if (found.size() > 1) refuse_ambiguous(typed, found);
  return found.front();
}

}  // namespace

std::string path_of_study(const std::string& id, const std::string& rest) {
  return "/v1/studies/" + id + rest;
}

bool is_study(const std::string& path) { return path.starts_with("/v1/studies/"); }

std::string path_of_any(Client& client, const std::string& typed) {
  const ordered_json found = matches(client, typed);
  std::vector<std::string> named, paths;
  for (const auto& [name, kind] : {std::pair{"study ", "studies"}, std::pair{"case ", "cases"}})
    for (const std::string id : found[kind]) {
      named.push_back(name + id);
      paths.push_back(std::string("/v1/") + kind + "/" + id);
      if (id == typed) return paths.back();
    }
  const bool is_one_study_among_cases = found["studies"].size() == 1 && paths.size() > 1;
  if (is_one_study_among_cases && client.get(paths.front())["name"] == typed) return paths.front();
  only_match("study or case", typed, named);
  return paths.front();
}

std::string study_id(Client& client, const std::string& typed) {
  return only_match("study", typed, matches(client, typed)["studies"].get<std::vector<std::string>>());
}

std::string whole_study_id(Client& client, const std::string& typed) {
  const std::string id = study_id(client, typed);
  if (typed == id || typed == client.get(path_of_study(id))["name"]) return id;
  throw std::invalid_argument("\"" + typed + "\" is only the beginning of " + id +
                              ": give the whole id or the name");
}

}  // namespace capstan
