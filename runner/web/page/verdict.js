// What is known of a case, as sentences.
import {answer_words, motion_words, number_words, sentence} from "./words.js";

const resolution_words = (companion) =>
  companion.nodes ? `the run at the coarser resolution (${companion.nodes} nodes)`
                  : companion.dx ? `the run at the coarser resolution (dx = ${companion.dx})`
                                 : "the run at the coarser resolution";

/// Why the motion of a case is not confirmed, or what confirms it.
function confirmation({motion, confirmed, error, evidence}) {
  if (motion === "undecided") return [];  // its explanation says what is missing; that is not resolution
  if (error?.unknown) return [sentence(`There is no estimated error: ${error.unknown}`)];
  if (!error?.companion) return ["There is no run at a coarser resolution to compare with, so there is no estimated error."];
  const {companion} = error;
  const label = companion.motion ? `says ${motion_words(companion.motion)}` : "has no answer";
  const agreement = error.label_agrees ? `agrees: ${motion_words(motion)}` : label;
  const sentences = [sentence(`${resolution_words(companion)} ${agreement}`)];
  if (typeof error.Q !== "number" || typeof evidence?.margin !== "number") return sentences;
  const is_smaller = error.Q < evidence.margin;
  sentences.push(
    `The estimated error of Q, ${number_words(error.Q)}, is ${is_smaller ? "smaller" : "not smaller"} than ` +
    `${number_words(evidence.margin)}, the error that the label tolerates (margin).`);
  if (!confirmed) sentences.push("So the label is not confirmed: a finer resolution could change it.");
  return sentences;
}

export function verdict(shown) {
  const sentences = [sentence(answer_words(shown))];
  if (shown.explanation) sentences.push(sentence(shown.explanation));
  if (shown.reasons) sentences.push(...shown.reasons.map(sentence));  // what it waits for, or where it runs
  else if (shown.message) sentences.push(sentence(shown.message));
  if (shown.motion) sentences.push(...confirmation(shown));
  if (shown.error?.asked) sentences.push(`An error of ${number_words(shown.error.asked)} was asked for; it is ${shown.error.met ? "" : "not "}met.`);
  return sentences;
}

/// "±0.0039" and its like for each error that was estimated.
export function error_words(error) {
  const names = {Q: "Q", D_xy: "D_xy", theta: "θ (radian)", period: "period (relative)"};
  return Object.entries(names)
    .filter(([key]) => typeof error?.[key] === "number")
    .map(([key, name]) => `${name} ±${number_words(error[key])}`)
    .join(", ");
}
