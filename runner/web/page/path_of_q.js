// The path of Q = D_xy (cos 2θ, sin 2θ) in its plane. A path around 0 is tumbling, one that leaves 0 aside is
// tank-treading; one that comes closer than 0.06 is a transition.
import {round_numbers} from "./axis_scale.js";
import {element, svg_element} from "./elements.js";
import {save_svg} from "./save_picture.js";

const kRound = 0.06;  // a section with |Q| below this is nearly round (solver/README.md)
const kSize = 300;
const kRim = 34;

/// [kt, Q_1, Q_2] for each record.
function path_of({kt, D_xy, theta}) {
  return D_xy.map((deformation, i) =>
    deformation === null || theta[i] === null ? null
      : [kt[i], deformation * Math.cos(2 * theta[i]), deformation * Math.sin(2 * theta[i])]).filter((point) => point);
}

function words(x, y, text, anchor) {
  return svg_element("text", {x, y, "text-anchor": anchor}, text);
}

function axes(at, reach) {
  const ticks = round_numbers(-reach, reach, 4);
  const [low, high] = [at(-reach), at(reach)];
  const lines = ticks.map((tick) => `M${at(tick)} ${high}v4M${low} ${at(tick)}h-4`).join("");
  return [
    svg_element("path", {class: "axis", d: `M${low} ${low}H${high}V${high}H${low}Z${lines}`}),
    svg_element("path", {class: "grid", d: `M${low} ${at(0)}H${high}M${at(0)} ${low}V${high}`}),
    ...ticks.map((tick) => words(at(tick), high + 15, tick, "middle")),
    ...ticks.map((tick) => words(low - 6, at(-tick) + 4, tick, "end")),
    words(at(0), kSize - 4, "D_xy cos 2θ", "middle"),
    words(low, low - 6, "D_xy sin 2θ", "start"),
  ];
}

export class PathOfQ {
  constructor() {
    this.picture = svg_element("svg", {viewBox: `-14 0 ${kSize + 14} ${kSize + 4}`, role: "img", class: "path-of-q",
                                       "aria-label": "Path of Q in its plane"});
    const save = element("button", {"aria-label": "path of Q (SVG)", click: () => save_svg(this.picture, "path_of_Q.svg")}, "SVG");
    this.place = element("figure", {}, this.picture, element("figcaption", {},
      "Path of Q, from the dot on. Around 0: tumbling. Beside 0: tank-treading. Into the grey circle, |Q| < 0.06: the section is nearly round. ", save));
  }

  /// \param curves  [{title, colour, history}]
  show(curves) {
    const paths = curves.map((curve) => path_of(curve.history));
    const reach = 1.1 * Math.max(2 * kRound, ...paths.flatMap((path) => path.flatMap(([, first, second]) => [Math.abs(first), Math.abs(second)])));
    const at = (value) => kRim + ((value + reach) / (2 * reach)) * (kSize - 2 * kRim);
    const place = ([, x, y]) => `${at(x).toFixed(1)} ${at(-y).toFixed(1)}`;
    this.picture.replaceChildren(
      ...axes(at, reach),
      svg_element("circle", {class: "round", cx: at(0), cy: at(0), r: at(kRound) - at(0)}),
      ...paths.flatMap((path, i) => path.length === 0 ? [] : [
        svg_element("path", {d: `M${path.map(place).join("L")}`, fill: "none", stroke: curves[i].colour, "stroke-width": 1.5}),
        svg_element("circle", {cx: at(path[0][1]), cy: at(-path[0][2]), r: 3.5, fill: curves[i].colour})]),
      ...this.markers(paths, curves, place));
    this.set_time(this.kt ?? 0);
  }

  /// The rings that mark Q at one time.
  markers(paths, curves, place) {
    this.marked = paths.map((path, i) => ({
      path, place, ring: svg_element("circle", {class: "now", r: 5, stroke: curves[i].colour, "aria-hidden": "true"}),
    })).filter(({path}) => path.length > 0);
    return this.marked.map(({ring}) => ring);
  }

  set_time(kt) {
    this.kt = kt;
    for (const {path, place, ring} of this.marked ?? []) {
      const point = path.findLast(([time]) => time <= kt) ?? path[0];
      ring.setAttribute("transform", `translate(${place(point)})`);
    }
  }
}
