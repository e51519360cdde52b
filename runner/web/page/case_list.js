// The cases of a study that has no two axes to draw over.
import {element} from "./elements.js";
import {get} from "./server.js";
import {answer_words, number_words, value_words} from "./words.js";

const kPage = 200;

const number_or_blank = (value) => (typeof value === "number" ? number_words(value) : "");

export class CaseList {
  /// \param open(cell, adds)  called for a case that is chosen; `adds`: beside those that are open
  constructor(open) {
    this.open = open;
    this.limit = kPage;
    this.place = element("div", {class: "case-list"});
  }

  async show(study, opened) {
    const path = `/v1/studies/${encodeURIComponent(study.id)}/cases?limit=${Math.min(1000, this.limit)}`;
    const {cases, next} = await get(path);
    const text = JSON.stringify([cases.map((item) => [item.id, item.state, item.kt, item.error]), opened]);
    if (text === this.shown) return;
    this.shown = text;
    const names = study.axes.map((axis) => axis.parameter);
    const heads = ["point", ...names, "answer", "margin", "error of Q", "kt"];
    const focus = this.place.contains(document.activeElement) ? document.activeElement.id : "";
    this.place.replaceChildren(
      element("table", {},
        element("thead", {}, element("tr", {}, heads.map((head) => element("th", {scope: "col"}, head)))),
        element("tbody", {}, cases.map((item) => this.row(item, names, opened)))),
      ...(next && this.limit < 1000 ? [this.more(study, opened)] : []));
    if (focus) document.getElementById(focus)?.focus();
  }

  row(item, names, opened) {
    const cell = {cases: [item.id]};
    const number = element("button", {
      id: `point-${item.point}`, "aria-pressed": opened.includes(item.id),
      click: (event) => this.open(cell, event.shiftKey),
    }, `${item.point}`);
    const values = [...names.map((name) => value_words(item.asked[name] ?? "")), answer_words(item),
                    number_or_blank(item.evidence?.margin), number_or_blank(item.error?.Q), number_or_blank(item.kt)];
    return element("tr", {}, element("td", {}, number), values.map((value) => element("td", {}, value)));
  }

  more(study, opened) {
    return element("button", {click: () => { this.limit += kPage; this.show(study, opened); }}, "Show more");
  }
}
