#pragma once
// What the runs of a study, or of a case, will model and what they will cost, before they are computed.
#include <nlohmann/json.hpp>

#include "runner/study/input_document.hpp"

namespace capstan {

/// The plan as JSON (schema/http.md): totals, then the groups of cases whose plans have the same words, the
/// largest first. A group holds these words, the number of its cases and the range of their costs. A case is
/// a study of one case.
/// \param document  holds a study or a case
nlohmann::ordered_json plan_json(const InputDocument& document);

}  // namespace capstan
