// Which axes of a study a diagram is drawn over, and at which values of the others.
import {element} from "./elements.js";
import {value_words} from "./words.js";

/// Axes with several values; of a boundary with a single row, the searched one and that of the row.
function drawn_axes(study) {
  const axes = study.axes.filter((axis) => axis.values.length > 1);
  if (axes.length > 1 || !study.boundary) return axes;
  const is_searched = ({parameter}) => parameter === study.boundary.along;
  return [study.axes.find(is_searched), study.axes.find((axis) => !is_searched(axis))].filter((axis) => axis);
}

/// True if there are two axes to draw over; else the study is shown as a list.
export const has_diagram = (study) => drawn_axes(study).length >= 2;

/// The axes that the address names, and the first ones for all that it leaves out: {x, y, at: {E_b: 0.015}}.
export function axes_of(study, link) {
  const axes = drawn_axes(study);
  const named = (name) => axes.find((axis) => axis.parameter === name);
  const x = named(link.x) ?? axes.find((axis) => axis.parameter !== link.y);
  const y = named(link.y === x.parameter ? null : link.y) ?? axes.find((axis) => axis !== x);
  const wanted = new Map(link.at.map((text) => [text.slice(0, text.indexOf("=")), text.slice(text.indexOf("=") + 1)]));
  const at = {};
  for (const {parameter, values} of axes)
    if (parameter !== x.parameter && parameter !== y.parameter)
      at[parameter] = values.find((value) => value_words(value) === wanted.get(parameter)) ?? values[0];
  return {x: x.parameter, y: y.parameter, at};
}

const at_list = (at) => Object.entries(at).map(([name, value]) => `${name}=${value_words(value)}`);

export function diagram_path(study, {x, y, at}) {
  const query = new URLSearchParams([["x", x], ["y", y], ...at_list(at).map((text) => ["at", text])]);
  return `/v1/studies/${encodeURIComponent(study.id)}/phase-diagram?${query}`;
}

function menu(label, options, chosen, change) {
  const choices = options.map((option) => element("option", {selected: option === chosen}, option));
  return element("label", {}, `${label} `, element("select", {change: (event) => change(event.target.value)}, choices));
}

/// Menus of the axes; none for a study with two axes. \param change(link)  called with what was chosen
export function axis_menus(study, chosen, change) {
  const axes = drawn_axes(study);
  if (axes.length < 3) return [];
  const names = axes.map((axis) => axis.parameter);
  const changed = (part) => {
    const next = {...chosen, ...part};
    change({x: next.x, y: next.y, at: at_list(next.at)});
  };
  const fixed = axes.filter(({parameter}) => parameter in chosen.at);
  return [
    menu("across", names, chosen.x, (x) => changed({x, y: x === chosen.y ? chosen.x : chosen.y})),
    menu("up", names, chosen.y, (y) => changed({y, x: y === chosen.x ? chosen.y : chosen.x})),
    ...fixed.map(({parameter, values}) =>
      menu(`${parameter} =`, values.map(value_words), value_words(chosen.at[parameter]),
        (text) => changed({at: {...chosen.at, [parameter]: text}}))),
  ];
}
