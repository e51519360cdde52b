// A study of one case that is asked for on the page, beside the points of another study.
import {post} from "./server.js";

const kMaxName = 30;

/// \param purpose  ends the name, as in fig17-point   \param base  all parameters of the case
export function study_of_case(study, purpose, description, base) {
  return {name: `${(study.name || study.id).slice(0, kMaxName)}-${purpose}`, description, base};
}

/// Submits it and calls `submitted` with the new study; says why if it is refused.
export async function submit_case(study, submitted) {
  await post("/v1/studies", JSON.stringify(study)).then(submitted, (error) => alert(error.message));
}
