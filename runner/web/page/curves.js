// D_xy and θ/π over kt, one curve for each case.
import {element} from "./elements.js";
import {save_png} from "./save_picture.js";
import uPlot from "./uPlot.js";

const kHeight = 220;

const colour_of = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/// Runs record at times of their own: the curves share one list of times, with gaps.
function joined(histories, column) {
  return uPlot.join(histories.map(({kt, [column]: values}) => [kt, values]));
}

function axis(label) {
  const stroke = colour_of("--text");
  const lines = {stroke: colour_of("--grid"), width: 1};
  return {label, stroke, grid: lines, ticks: lines, font: "12px sans-serif", labelFont: "13px sans-serif"};
}

/// \param curves  [{title, colour, history}]
function options(label, curves, width) {
  const series = curves.map(({title, colour}) => ({label: title, stroke: colour, width: 1.5, spanGaps: true}));
  return {
    width, height: kHeight, series: [{label: "kt"}, ...series], axes: [axis("kt"), axis(label)],
    scales: {x: {time: false}}, legend: {live: true}, cursor: {drag: {x: true, y: false}},
  };
}

/// The line is moved again whenever the range of the time has changed.
const with_hook = (given, moved) => ({...given, hooks: {setScale: [(_, key) => key === "x" && moved()]}});

const of_pi = (history) => ({...history, theta: history.theta.map((angle) => angle === null ? null : angle / Math.PI)});

/// Drawn when the place has its width, and again when that changes.
class Curve {
  constructor(label, column) {
    this.label = label;
    this.column = column;
    this.cursor = element("div", {class: "time-cursor", "aria-hidden": "true"});
    this.plot_place = element("div");
    const save = element("button", {"aria-label": `${label} over kt (PNG)`, click: () => save_png(this.plot.ctx.canvas, `${column}.png`)}, "PNG");
    this.place = element("figure", {class: "curve", "aria-label": `${label} over kt`}, this.plot_place, save);
    new ResizeObserver(() => this.plot?.setSize({width: this.place.clientWidth, height: kHeight})).observe(this.place);
  }

  show(curves) {
    this.plot?.destroy();
    const data = joined(curves.map((curve) => curve.history), this.column);
    this.plot = new uPlot(with_hook(options(this.label, curves, this.place.clientWidth || 600), () => this.set_time(this.kt)), data, this.plot_place);
    this.plot.over.append(this.cursor);
    this.set_time(this.kt ?? 0);
  }

  /// Moves the line that marks the time; out of sight where the curve is magnified beside it.
  set_time(kt) {
    this.kt = kt;
    if (!this.plot) return;
    const {min, max} = this.plot.scales.x;
    const share = (kt - min) / (max - min);
    this.cursor.hidden = !(share >= 0 && share <= 1);
    this.cursor.style.left = `${100 * share}%`;
  }
}

export class Curves {
  constructor() {
    this.deformation = new Curve("D_xy", "D_xy");
    this.inclination = new Curve("θ/π", "theta");
    this.place = element("div", {class: "curves"}, this.deformation.place, this.inclination.place);
  }

  show(curves) {
    this.deformation.show(curves);
    this.inclination.show(curves.map((curve) => ({...curve, history: of_pi(curve.history)})));
  }

  set_time(kt) {
    this.deformation.set_time(kt);
    this.inclination.set_time(kt);
  }
}
