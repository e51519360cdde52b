// The cases that are open: their details side by side, their curves in common pictures.
import {Capsules} from "./capsules.js";
import {case_details} from "./case_details.js";
import {Curves} from "./curves.js";
import {element} from "./elements.js";
import {PathOfQ} from "./path_of_q.js";
import {get} from "./server.js";
import {TimeSlider} from "./time_slider.js";
import {value_words} from "./words.js";

const kColours = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"];  // Okabe and Ito

/// A failed or cancelled case may be tried again.
const is_final = (shown) => ["done", "diverged"].includes(shown.state);

const drawn_words = ({shown, history}) => [shown.id, history.kt.length];
const told_words = ({shown}) => [shown.id, shown.state, shown.motion, shown.message, shown.reasons];

export class OpenCases {
  /// \param close(id)              called when a case is closed
  /// \param compute_shapes(shown)  called for a case that is to be computed again, with its shapes
  constructor(close, compute_shapes) {
    this.close = close;
    this.known = new Map();  // cases that will not change, with their histories
    this.curves = new Curves();
    this.path = new PathOfQ();
    this.capsules = new Capsules(compute_shapes);
    this.slider = new TimeSlider((kt) => [this.capsules, this.curves, this.path].forEach((shown) => shown.set_time(kt)));
    this.cases = element("div", {class: "cases"});
    this.pictures = element("div", {class: "pictures"}, this.path.place, this.curves.place);
    this.place = element("div", {class: "opened-cases", hidden: true}, this.cases, this.slider.place, this.capsules.place, this.pictures);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    this.cases_shown = [];
  }

  async show(ids, names) {
    const cases = await Promise.all(ids.map((id) => this.read(id)));
    this.place.hidden = cases.length === 0;
    this.cases_shown = cases.map(({shown, history}, i) => ({
      shown, history, colour: kColours[i % kColours.length],
      title: names.map((name) => `${name} ${value_words(shown.parameters[name] ?? "–")}`).join(", ") || shown.id,
    }));
    this.tell(names);
    this.draw_if_changed();
    await this.capsules.show(this.cases_shown);
  }

  /// Made anew only if there is something new: what the reader has unfolded stays so.
  tell(names) {
    const text = JSON.stringify(this.cases_shown.map(told_words));
    if (text === this.told) return;
    this.told = text;
    this.cases.replaceChildren(...this.cases_shown.map(({shown, colour}) =>
      case_details(shown, names, colour, () => this.close(shown.id))));
  }

  draw_if_changed() {
    const text = JSON.stringify(this.cases_shown.map(drawn_words));
    if (text !== this.drawn) this.draw();
    this.drawn = text;
  }

  async read(id) {
    if (this.known.has(id)) return this.known.get(id);
    const path = `/v1/cases/${encodeURIComponent(id)}`;
    const [shown, history] = await Promise.all([get(path), get(`${path}/history`)]);
    if (is_final(shown)) this.known.set(id, {shown, history});
    if (["queued", "running"].includes(shown.state)) shown.reasons = (await get(`${path}/why`)).reasons;
    return {shown, history};
  }

  draw() {
    const curves = this.cases_shown.filter(({history}) => history.kt.length > 0);
    this.slider.place.hidden = this.pictures.hidden = curves.length === 0;
    if (curves.length === 0) return;
    this.curves.show(curves);
    this.path.show(curves);
    this.slider.set_end(Math.max(...curves.map(({history}) => history.kt.at(-1))));
  }
}
