// The boundary between two motions in a phase diagram: a band in which the motion is a transition, the line where Q
// passes through 0, and for each point of it a bar between its bounds.
import {svg_element} from "./elements.js";
import {value_words} from "./words.js";

/// True if the curve belongs to the section that the diagram shows.
const stands_at = (curve, at) =>
  Object.entries(curve.at).every(([name, value]) => !(name in at) || value_words(at[name]) === value_words(value));

/// The two sides of a band or bar; a side that is not known is the end of the searched range.
const sides = (low, high, between) => [low ?? between[0], high ?? between[1]];

/// \param boundary  the answer of the server   \param diagram  with x, y and at   \param scales  {x, y} of axis_scale
/// \return SVG elements; none for a diagram over other axes
export function boundary_elements(boundary, diagram, scales) {
  const {along, between} = boundary;
  const along_x = along === diagram.x.parameter;
  if (!along_x && along !== diagram.y.parameter) return [];
  const over = along_x ? diagram.y.parameter : diagram.x.parameter;
  const [along_scale, over_scale] = along_x ? [scales.x, scales.y] : [scales.y, scales.x];
  if (!along_scale.numeric || !over_scale.numeric) return [];
  const point = (value, row) => {
    const places = [along_scale.place_of(value), over_scale.place_of(row)];
    return (along_x ? places : places.reverse()).map((place) => place.toFixed(2)).join(" ");
  };
  const line = (points) => (points.length ? `M${points.join("L")}${points.length === 1 ? "h0" : ""}` : "");
  return boundary.curves.filter((curve) => curve.over === over && stands_at(curve, diagram.at)).flatMap(({points}) => {
    const bands = points.filter(({band}) => band).map((p) => [sides(...p.band, between), p.over]);
    const rim = [...bands.map(([[low], row]) => point(low, row)), ...bands.reverse().map(([[, high], row]) => point(high, row))];
    const bars = points.filter(({low, high}) => low !== null || high !== null).map((p) => {
      const [low, high] = sides(p.low, p.high, between);
      return line([point(low, p.over), point(high, p.over)]);
    });
    const single = points.length === 1 ? " single" : "";  // a bar and a dot instead of an area and a line
    return [
      svg_element("path", {class: `band${single}`, d: `${line(rim)}Z`}),
      svg_element("path", {class: "bounds", d: bars.join("")}),
      svg_element("path", {class: `boundary${single}`, d: line(points.filter(({value}) => value !== null).map((p) => point(p.value, p.over)))}),
    ];
  });
}

/// Where the boundary lies, in sentences for those who do not see it.
export function boundary_words(boundary) {
  const rows = boundary.rows.flatMap(({at, crossings}) => crossings.filter(({value}) => value !== null).map((crossing) => {
    const place = Object.entries(at).map(([name, value]) => `${name} = ${value_words(value)}`).join(", ");
    const [low, high] = [crossing.low, crossing.high].map((limit) => limit === null ? "beyond the range" : number(limit));
    const bounds = crossing.low === null && crossing.high === null ? " (no limits: errors unknown or too large)" : ` (${low} to ${high})`;
    return `${place || "boundary"}: ${boundary.along} = ${number(crossing.value)}${bounds}`;
  }));
  const state = boundary.searching ? `Searching; ${boundary.points.ended} of ${boundary.points.asked} points so far, about ${boundary.points.expected} more` :
    boundary.points.ended < boundary.points.asked ? `Cancelled; ${boundary.points.ended} of ${boundary.points.asked} points` :
    boundary.rows.some(({first}) => first === null) ? "Searched, but some rows have no motion: raise until.at_most" : "Found";
  return `${state}. ${rows.join("; ")}`;
}

const number = (value) => String(Number(value.toPrecision(3)));
