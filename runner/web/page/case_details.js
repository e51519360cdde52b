// One case: its label in sentences, its errors, warnings, what is left out, parameters, files.
import {download_link} from "./download.js";
import {element} from "./elements.js";
import {error_words, verdict} from "./verdict.js";
import {sentence, value_words} from "./words.js";

/// {fidelity: {nodes: 642}} as [["fidelity.nodes", 642]]
function flat(parameters, prefix = "") {
  return Object.entries(parameters).flatMap(([key, value]) =>
    value !== null && typeof value === "object" && !Array.isArray(value)
      ? flat(value, `${prefix}${key}.`) : [[prefix + key, value]]);
}

function folded(title, ...content) {
  return element("details", {}, element("summary", {}, title), ...content);
}

const list = (sentences) => element("ul", {}, sentences.map((text) => element("li", {}, sentence(text))));

function choices_of(shown) {
  return (shown.choices ?? []).map(({key, chosen, reason}) => `${key} = ${value_words(chosen)}: ${reason}`);
}

/// \param names   parameters that vary in the study: the title
/// \param colour  of its curves
/// \param close   called when the case is closed
export function case_details(shown, names, colour, close) {
  const title = names.map((name) => `${name} = ${value_words(shown.parameters[name] ?? "–")}`).join(", ") || shown.id;
  const path = `/v1/cases/${shown.id}`;
  const line = element("span", {class: "line", "aria-hidden": "true"});
  line.style.background = colour;
  const warnings = shown.trust?.warnings ?? [];
  const left_out = shown.trust?.left_out ?? [];
  const choices = choices_of(shown);
  return element("section", {class: "case", "aria-label": title},
    element("h3", {}, line, title, element("button", {class: "close", "aria-label": `close ${title}`, click: close}, "×")),
    ...verdict(shown).map((text) => element("p", {}, text)),
    error_words(shown.error) ? element("p", {}, `Estimated errors: ${error_words(shown.error)}.`) : null,
    warnings.length ? element("div", {class: "warnings"}, element("h4", {}, "Warnings"), list(warnings)) : null,
    left_out.length ? folded(`Left out of the model (${left_out.length})`, list(left_out)) : null,
    choices.length ? folded("Chosen by the solver", list(choices)) : null,
    folded("Parameters", element("dl", {}, flat(shown.parameters).map(([key, value]) =>
      [element("dt", {}, key), element("dd", {}, value_words(value))]))),
    element("p", {class: "files"},
      download_link("history (CSV)", `${path}/history?format=csv`, `${shown.id}.csv`), " ",
      download_link("history (JSON)", `${path}/history`, `${shown.id}_history.json`), " ",
      download_link("case (JSON)", path, `${shown.id}.json`)));
}
