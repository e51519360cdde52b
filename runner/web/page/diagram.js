// A phase diagram: one mark for each point, which can be reached by mouse, touch and arrow keys. Between the marks a
// click names a place, and a rectangle that is drawn with the mouse is magnified.
import {axis_scale} from "./axis_scale.js";
import {boundary_elements} from "./boundary.js";
import {Brush} from "./brush.js";
import {element, set_text, svg_element} from "./elements.js";
import {mark_classes, mark_of, outline_of} from "./marks.js";
import {answer_words, motion_words, value_words} from "./words.js";

const kWidth = 640;
const kHeight = 440;
const kFrame = {left: 52, right: 628, top: 26, bottom: 396};
const kMaxRadius = 7;
const kMinRadius = 1.3;
const kMinRadiusOfFew = 4;  // an open mark can be told from a filled one
const kFew = 1000;          // points
const kReach = 16;  // from the mouse to the mark that it means
const kSteps = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1]};

/// Small enough that neighbours do not overlap.
function radius_of(places) {
  const gaps = places.slice(1).map((place, i) => Math.abs(place - places[i]));
  return Math.min(kMaxRadius, ...gaps.map((gap) => 0.42 * gap));
}

export class Diagram {
  /// \param open(cell, adds)  called for a point that is chosen; `adds`: beside those that are open
  /// \param compute({Ca, V})  called for a place without a point
  /// \param magnify(range)    called with [first, last] of x and y, or null for the whole diagram
  constructor(open, compute, magnify) {
    this.open = open;
    this.compute = compute;
    this.magnify = magnify;
    this.tip = element("p", {class: "tip", hidden: true});
    this.picture = svg_element("svg", {viewBox: `0 0 ${kWidth} ${kHeight}`, role: "group", class: "diagram"});
    this.key = element("p", {class: "key"});
    this.whole = element("button", {hidden: true, click: () => this.magnify(null)}, "Show the whole diagram");
    this.place = element("div", {class: "diagram-place"}, this.picture, this.tip, this.key, this.whole);
    this.lines = svg_element("g");
    this.others = svg_element("g");
    this.brush = new Brush(this.picture, kFrame, (area) => this.magnify_area(area));
    this.listen();
  }

  listen() {
    this.picture.addEventListener("click", (event) => this.click(event));
    this.picture.addEventListener("keydown", (event) => this.press(event));
    this.picture.addEventListener("pointermove", (event) => this.show_tip(this.point_at(event)));
    this.picture.addEventListener("pointerleave", () => this.show_tip(null));
    this.picture.addEventListener("focusin", (event) => this.show_tip(this.point_of(event.target)));
    this.picture.addEventListener("focusout", () => this.show_tip(null));
  }

  /// \param opened  ids of the cases that are open
  /// \param ranges  [first, last] of x and of y that are shown, or null for all
  show(diagram, opened, ranges) {
    const frame = JSON.stringify([diagram.x, diagram.y, diagram.at, ranges]);
    if (frame !== this.frame) this.draw_frame(diagram, ranges);
    this.frame = frame;
    this.diagram = diagram;
    diagram.rows.flat().forEach((cell, index) => this.draw(this.points[index], cell, opened));
    this.show_key(diagram);
  }

  draw_frame({x, y, at, rows}, ranges) {
    this.x = axis_scale(x.values, kFrame.left, kFrame.right, ranges?.[0]);
    this.y = axis_scale(y.values, kFrame.bottom, kFrame.top, ranges?.[1]);
    this.whole.hidden = !ranges;
    this.names = {x: x.parameter, y: y.parameter};
    this.columns = x.values.length;
    const points = rows.flat().filter(({cases}) => cases.length > 0).length;
    this.radius = Math.max(points > kFew ? kMinRadius : kMinRadiusOfFew, Math.min(radius_of(x.values.map((_, i) => this.x.place(i))),
                                                radius_of(y.values.map((_, i) => this.y.place(i)))));
    const fixed = Object.entries(at).map(([name, value]) => `, ${name} = ${value_words(value)}`).join("");
    this.picture.setAttribute("aria-label", `Phase diagram over ${x.parameter} and ${y.parameter}${fixed}`);
    this.points = rows.flatMap((row, j) => row.map((_, i) => this.new_point(i, j, x.values[i], y.values[j])));
    const shown = this.points.filter((point) => this.x.shows(point.column) && this.y.shows(point.row));
    this.picture.replaceChildren(...this.axes(), this.lines, svg_element("g", {}, shown.map((point) => point.mark)),
                                 this.others, this.brush.area);
    this.boundary = null;
    this.lines.replaceChildren();
    this.points.find(({column, row}) => rows[row][column].cases.length > 0)?.mark.setAttribute("tabindex", 0);
  }

  axes() {
    const {left, right, top, bottom} = kFrame;
    const text = (x, y, words, anchor, name = "") =>
      svg_element("text", {x, y, "text-anchor": anchor, class: name, "aria-hidden": "true"}, words);
    const lines = [`M${left} ${top}H${right}V${bottom}H${left}Z`];
    for (const {place} of this.x.ticks) lines.push(`M${place} ${bottom}v5`);
    for (const {place} of this.y.ticks) lines.push(`M${left} ${place}h-5`);
    return [
      svg_element("path", {d: lines.join(""), class: "axis"}),
      ...this.x.ticks.map((tick) => text(tick.place, bottom + 18, tick.text, "middle")),
      ...this.y.ticks.map((tick) => text(left - 8, tick.place + 4, tick.text, "end")),
      text((left + right) / 2, kHeight - 6, this.names.x, "middle", "name"),
      text(left - 8, top - 12, this.names.y, "end", "name"),
    ];
  }

  new_point(column, row, x, y) {
    const place = {x: this.x.place(column), y: this.y.place(row)};
    const mark = svg_element("path", {
      transform: `translate(${place.x.toFixed(2)} ${place.y.toFixed(2)}) scale(${this.radius.toFixed(2)})`,
      role: "button",
      tabindex: -1,
    });
    const words = `${this.names.x} = ${value_words(x)}, ${this.names.y} = ${value_words(y)}`;
    const point = {column, row, place, mark, words, cell: null, drawn: ""};
    mark.point = point;
    return point;
  }

  /// \param boundary  the answer of the server, or null
  show_boundary(boundary) {
    const text = JSON.stringify(boundary);
    if (text === this.boundary) return;
    this.boundary = text;
    this.lines.replaceChildren(...(boundary ? boundary_elements(boundary, this.diagram, {x: this.x, y: this.y}) : []));
  }

  /// Marks of open cases that are no points of the study. \param cases  [{x, y, motion, state, confirmed}]
  show_others(cases) {
    const size = this.radius.toFixed(2);
    this.others.replaceChildren(...cases.map((shown) => svg_element("path", {
      class: `${mark_classes(shown)} opened`, d: outline_of(mark_of(shown)), role: "img",
      "aria-label": `${this.names.x} = ${shown.x}, ${this.names.y} = ${shown.y}: ${answer_words(shown)}`,
      transform: `translate(${this.x.place_of(shown.x)} ${this.y.place_of(shown.y)}) scale(${size})`,
    })));
  }

  /// Touches the mark only if something has changed: a diagram may have 10,000 of them.
  draw(point, cell, opened) {
    point.cell = cell;
    const is_open = cell.cases.some((id) => opened.includes(id));
    const drawn = cell.cases.length === 0 ? "mark empty" : `${mark_classes(cell)}${is_open ? " opened" : ""}`;
    if (drawn === point.drawn) return;
    point.drawn = drawn;
    point.mark.setAttribute("class", drawn);
    point.mark.setAttribute("d", outline_of(mark_of(cell)));
    point.mark.setAttribute("aria-label", `${point.words}: ${answer_words(cell)}`);
    point.mark.setAttribute("aria-pressed", is_open);
  }

  show_key({rows}) {
    const counts = new Map();
    for (const cell of rows.flat().filter(({cases}) => cases.length > 0)) {
      const words = cell.motion ? motion_words(cell.motion) : answer_words(cell);
      const entry = counts.get(words) ?? {cell: {...cell, confirmed: true}, count: 0, open: 0};
      entry.count += 1;
      entry.open += cell.motion && !cell.confirmed ? 1 : 0;
      counts.set(words, entry);
    }
    const text = JSON.stringify([...counts]);
    if (text === this.shown_key) return;
    this.shown_key = text;
    this.key.replaceChildren(...[...counts].map(([words, {cell, count, open}]) =>
      element("span", {}, this.small_mark(cell), ` ${words} ${count}${open ? ` (${open} not confirmed: open marks)` : ""}`)));
  }

  small_mark(cell) {
    return svg_element("svg", {viewBox: "-1.6 -1.6 3.2 3.2", class: "small-mark", "aria-hidden": "true"},
      svg_element("path", {d: outline_of(mark_of(cell)), class: mark_classes(cell)}));
  }

  point_of(target) {
    return target.point ?? null;
  }

  /// The place of the mouse in the picture.
  place_at(event) {
    const matrix = this.picture.getScreenCTM();
    return matrix && new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  }

  /// The point under the mouse, or else the nearest one within reach.
  point_at(event) {
    if (event.target.point) return event.target.point;
    const at = this.place_at(event);
    return at && this.points ? this.nearest_point(at, kReach) : null;
  }

  nearest_point(at, reach) {
    let best = null;
    for (const point of this.points) {
      if (point.cell.cases.length === 0) continue;
      const distance = Math.hypot(point.place.x - at.x, point.place.y - at.y);
      if (distance < reach) [best, reach] = [point, distance];
    }
    return best;
  }

  show_tip(point) {
    this.tip.hidden = !point;
    if (!point) return;
    set_text(this.tip, `${point.words}: ${answer_words(point.cell)}`);
    const is_right = point.place.x > kWidth / 2;
    this.tip.style.left = is_right ? "" : `${(100 * (point.place.x + 12)) / kWidth}%`;
    this.tip.style.right = is_right ? `${100 - (100 * (point.place.x - 12)) / kWidth}%` : "";
    this.tip.style.top = `${(this.picture.clientHeight * (point.place.y + 8)) / kHeight}px`;
  }

  click(event) {
    if (this.brush.has_just_ended) return;
    const point = this.point_at(event);
    if (point) this.choose(point, event);
    else this.compute_at(this.place_at(event));
  }

  /// Only where both axes have numbers.
  compute_at(at) {
    const {left, right, top, bottom} = kFrame;
    const is_inside = at && at.x > left && at.x < right && at.y > top && at.y < bottom;
    if (!is_inside || !this.x.numeric || !this.y.numeric) return;
    const place = {[this.names.x]: this.x.number_at(at.x), [this.names.y]: this.y.number_at(at.y)};
    this.compute(place, this.nearest_point(at, Infinity)?.cell.cases[0]);
  }

  /// The middle of the diagram, for those who use no mouse.
  compute_in_the_middle() {
    this.compute_at({x: (kFrame.left + kFrame.right) / 2, y: (kFrame.top + kFrame.bottom) / 2});
  }

  magnify_area({left, right, top, bottom}) {
    if (!this.x.numeric || !this.y.numeric) return;
    this.magnify([[this.x.number_at(left), this.x.number_at(right)], [this.y.number_at(bottom), this.y.number_at(top)]]);
  }

  choose(point, event) {
    if (!point || point.cell.cases.length === 0) return;
    this.make_current(point);
    this.open(point.cell, event.shiftKey);
  }

  press(event) {
    const point = this.point_of(event.target);
    if (!point) return;
    if (event.key === "Enter" || event.key === " ") this.choose(point, event);
    else if (event.key in kSteps) this.step(point, kSteps[event.key]);
    else return;
    event.preventDefault();
  }

  /// To the next place that has a point; in a sparse diagram, up and down lead to the nearest point of the next row.
  step(point, [right, up]) {
    const ahead = this.points.filter(({cell, mark, column, row}) => cell.cases.length > 0 && mark.isConnected &&
      (right ? row === point.row && (column - point.column) * right > 0 : (row - point.row) * up > 0));
    const distance = ({column, row}) => this.columns * Math.abs(row - point.row) + Math.abs(column - point.column);
    const next = ahead.reduce((best, other) => (best && distance(best) <= distance(other) ? best : other), null);
    if (!next) return;
    this.make_current(next);
    next.mark.focus();
  }

  /// Tab reaches one point of the diagram; the arrow keys reach the others.
  make_current(point) {
    this.picture.querySelector("[tabindex='0']")?.setAttribute("tabindex", -1);
    point.mark.setAttribute("tabindex", 0);
  }
}
