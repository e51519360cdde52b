// The capsules of the open cases side by side, in common colours.
import {CapsuleView} from "./capsule_view.js";
import {gradient} from "./colour_map.js";
import {element, set_text} from "./elements.js";
import {get} from "./server.js";
import {load_shapes} from "./shapes.js";
import {fields_of, range_of} from "./vertex_fields.js";
import {number_words} from "./words.js";

const kNothing = 1e-6;  // of the largest number: rounding errors

const shapes_path = (id) => `/v1/cases/${encodeURIComponent(id)}/shapes`;

export class Capsules {
  /// \param compute(shown)  called for a case that is to be computed again, with its shapes
  constructor(compute) {
    this.compute = compute;
    this.known = new Map();  // views of cases, with their fields, by id
    this.kt = 0;
    this.views = element("div", {class: "capsules"});
    this.choice = element("select", {change: () => this.colour()});
    this.low = element("span");
    this.high = element("span");
    const bar = element("span", {class: "colour-bar", "aria-hidden": "true"});
    bar.style.background = gradient();
    this.key = element("p", {class: "hint", hidden: true},
      element("label", {}, "Colour: ", this.choice), " ", this.low, " ", bar, " ", this.high,
      ". The ball is fixed to the membrane; the arrows show the flow.");
    this.place = element("div", {}, this.views, this.key);
  }

  /// \param cases  [{shown, title, colour}]
  async show(cases) {
    const asked = this.asked = cases;
    const views = [];
    for (const item of cases) views.push(await this.view_of(item));
    const same = views.length === this.all?.length && views.every((view, i) => view === this.all[i]);
    if (asked !== this.asked || same) return;  // other cases have been opened meanwhile, or nothing is new
    this.all = views;
    this.shown = views.filter(({view}) => view);
    this.views.replaceChildren(...views.map(({place}) => place));
    this.offer_fields();
  }

  /// Loaded anew only if the case has recorded more shapes since.
  async view_of(item) {
    const {id} = item.shown;
    const {kt: times} = await get(shapes_path(id));
    const text = JSON.stringify([times.length || item.shown.state, item.title, item.colour]);
    if (this.known.get(id)?.text !== text) this.known.set(id, {text, ...await this.new_view(item, times)});
    return this.known.get(id);
  }

  async new_view(item, times) {
    const shapes = await load_shapes(item.shown.id, times);
    if (!shapes) return {place: this.no_shapes(item)};
    const {CapsuleScene} = await import("./capsule_scene.js");
    const view = new CapsuleView(item, new CapsuleScene(shapes.triangles, shapes.positions[0]), shapes);
    return {place: view.place, view, fields: fields_of(shapes)};
  }

  no_shapes({shown, title}) {
    if (["queued", "running"].includes(shown.state) && shown.parameters.outputs.shapes_every > 0)
      return element("p", {class: "hint"}, `${title}: no shape is recorded yet.`);
    return element("p", {class: "hint"}, `${title}: this case has recorded no shapes. `,
      element("button", {click: () => this.compute(shown)}, "Compute its shapes"));
  }

  offer_fields() {
    this.key.hidden = this.shown.length === 0;
    if (this.shown.length === 0) return;
    const chosen = this.choice.value;
    const names = this.shown[0].fields.filter(({name}) => this.shown.every(({fields}) => fields.some((f) => f.name === name)));
    this.choice.replaceChildren(...names.map(({name, words}) => element("option", {value: name, selected: name === chosen}, words)));
    this.colour();
  }

  field_of = ({fields}) => fields.find(({name}) => name === this.choice.value);

  /// All views have the same colours for the same numbers.
  colour() {
    const ranges = this.shown.map((item) => range_of(this.field_of(item).rows));
    this.range = [Math.min(...ranges.map(([low]) => low)), Math.max(...ranges.map(([, high]) => high))];
    const [low, high] = this.range.map((number) => (Math.abs(number) < kNothing * this.range[1] ? 0 : number));
    set_text(this.low, number_words(low, 3));
    set_text(this.high, number_words(high, 3));
    this.set_time(this.kt);
  }

  set_time(kt) {
    this.kt = kt;
    for (const item of this.shown ?? []) item.view.show(kt, this.field_of(item), this.range);
  }
}
