// A form to check and submit a study. A check stores nothing.
import {download_link} from "./download.js";
import {element} from "./elements.js";
import {go_to} from "./link.js";
import {post} from "./server.js";
import {duration_words, sentence} from "./words.js";

const kExample = `{
  "name": "example",
  "base": {
    "shape": "biconcave", "law": "skalak", "C": 5, "E_b": 0.015,
    "fluid": "stokes", "until": {"kt": 30}, "fidelity": "fast"
  },
  "axes": {
    "Ca": [0.1, 0.25, 0.5, 1],
    "V": [1, 2, 4, 8]
  }
}`;

function plan_words(plan) {
  const total = plan.seconds.total ?? plan.seconds.max;
  const warnings = (plan.groups ?? []).flatMap((group) => group.warnings.map(({text, cases}) => `${cases} cases: ${text}`));
  return [`Valid: ${plan.cases} cases, about ${duration_words(total)} of one core.${plan.grows ? " Further cases follow where the motion changes." : ""}`, ...warnings.map(sentence)];
}

function refusal_words(error) {
  return [error.message, ...(error.issues ?? []).map(({pointer, detail}) => `${pointer || "the whole"}: ${detail}`)];
}

export class SubmitForm {
  constructor() {
    this.text = element("textarea", {id: "study-text", rows: 14, spellcheck: "false"}, kExample);
    this.answer = element("ul", {role: "status"});
    this.place = element("details", {class: "submit"},
      element("summary", {}, "New study"),
      element("label", {for: "study-text"}, "A study as JSON (", download_link("schema", "/study.schema.json", "study.schema.json"), ")"),
      this.text,
      element("p", {},
        element("button", {click: () => this.check()}, "Check"), " ",
        element("button", {click: () => this.submit()}, "Submit")),
      this.answer);
  }

  say(sentences) {
    this.answer.replaceChildren(...sentences.map((text) => element("li", {}, text)));
  }

  async check() {
    await post("/v1/plan", this.text.value).then((plan) => this.say(plan_words(plan)), (error) => this.say(refusal_words(error)));
  }

  async submit() {
    await post("/v1/studies", this.text.value).then((study) => {
      this.say([`Submitted: ${study.id}.`, ...study.warnings]);
      go_to({study: study.id});
    }, (error) => this.say(refusal_words(error)));
  }
}
