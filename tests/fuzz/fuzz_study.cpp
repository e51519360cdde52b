// Fuzz target: the parser of studies gets any bytes. It must return either a study or issues; and the
// document of a study must parse to the same cases again.
#include <cstdint>
#include <cstdlib>
#include <set>

#include "runner/study/study.hpp"
#include "solver/case/content_id.hpp"

using namespace capstan;

namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

std::set<std::string> ids_of(const Study& study) {
  std::set<std::string> ids;
  for (const Case& c : study.cases) ids.insert(case_id(c));
  return ids;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ParsedStudy parsed = parse_study_text({reinterpret_cast<const char*>(data), size});
  require(parsed.value.has_value() == parsed.issues.empty());
  if (!parsed.value || parsed.value->cases.size() > 100) return 0;
  const std::set<std::string> ids = ids_of(*parsed.value);
  require(!ids.empty() && ids.size() == parsed.value->cases.size());
  const ParsedStudy again = parse_study_text(parsed.value->document.dump());
  require(again.value && ids_of(*again.value) == ids);
  return 0;
}
