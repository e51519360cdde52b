// Asks for the place of a point that is to be computed, shows what it costs, and submits it as a study of one case.
import {study_of_case, submit_case} from "./case_study.js";
import {element} from "./elements.js";
import {post} from "./server.js";
import {duration_words, sentence} from "./words.js";

const kDigits = 3;

export const rounded = (value) => Number(value.toPrecision(kDigits));

/// The study of one point: all parameters as at the nearest one that is computed, but the two of the axes.
function study_of_point(study, nearest, place) {
  const words = Object.entries(place).map(([name, value]) => `${name} = ${value}`).join(", ");
  return study_of_case(study, "point", `${words}, a point beside those of ${study.id}.`, {...nearest, ...place});
}

export class PointDialog {
  /// \param submitted(study)  called with the new study
  constructor(submitted) {
    this.submitted = submitted;
  }

  /// \param place    {Ca: 0.4, V: 3}   \param nearest  parameters of the nearest case
  open(study, place, nearest) {
    this.fields = Object.entries(place).map(([name, value]) =>
      [name, element("input", {type: "number", step: "any", min: 0, value: rounded(value), required: true, input: () => this.plan()})]);
    this.make_study = () => study_of_point(study, nearest, Object.fromEntries(
      this.fields.map(([name, field]) => [name, Number(field.value)])));
    this.words = element("p", {role: "status"});
    this.go = element("button", {value: "go"}, "Compute");
    this.dialog = element("dialog", {"aria-labelledby": "point-title"},
      element("form", {method: "dialog"},
        element("h3", {id: "point-title"}, "Compute another point"),
        this.fields.map(([name, field]) => element("label", {}, `${name} = `, field)),
        element("p", {class: "hint"}, "Everything else is as at the nearest point. It becomes a study of one case, which is shown here and kept in the list."),
        this.words,
        element("p", {}, this.go, " ", element("button", {value: "", formnovalidate: true}, "Do not"))));
    document.body.append(this.dialog);
    this.dialog.addEventListener("close", () => this.close());
    this.dialog.showModal();
    this.plan();
  }

  async plan() {
    const study = JSON.stringify(this.make_study());
    const words = await post("/v1/plan", study).then(
      ({seconds}) => `It takes about ${duration_words(seconds.total ?? seconds.max)} of one core.`,
      (error) => [error.message, ...(error.issues ?? []).map(({pointer, detail}) => `${pointer}: ${detail}`)].map(sentence).join(" "));
    this.words.textContent = words;
  }

  async close() {
    const study = this.dialog.returnValue === "go" ? this.make_study() : null;
    this.dialog.remove();
    if (study) await submit_case(study, this.submitted);
  }
}
