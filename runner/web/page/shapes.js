// The recorded shapes of a case, and the shape at any time between them.
import {request} from "./server.js";
import {read_tensors} from "./tensors.js";

const kFields = ["positions", "velocities", "forces", "stretches"];

/// The rows of an array, one for each time.
function rows_of({shape, numbers}) {
  const length = numbers.length / shape[0];
  return Array.from({length: shape[0]}, (_, i) => numbers.subarray(i * length, (i + 1) * length));
}

/// All shapes of a case; an answer holds as many as fit. Null if the case has recorded none.
/// \return {times, triangles, positions, velocities, forces, stretches}: one row a time; stretches may be absent
export async function load_shapes(id, times) {
  if (times.length === 0) return null;
  const shapes = {times: []};
  for (let total = 1; shapes.times.length < total;) {
    const path = `/v1/cases/${encodeURIComponent(id)}/shapes?format=binary&first=${shapes.times.length}`;
    const {notes, arrays} = read_tensors(await (await request(path)).arrayBuffer());
    total = Number(notes.total);
    shapes.times.push(...arrays.kt.numbers);
    shapes.triangles = arrays.triangles.numbers;
    for (const name of kFields)
      if (arrays[name]) shapes[name] = (shapes[name] ?? []).concat(rows_of(arrays[name]));
  }
  return shapes;
}

/// The last recorded time at or before kt, and how far kt is on the way to the next one, from 0 to 1.
function place_in(times, kt) {
  const after = times.findIndex((time) => time > kt);
  const index = after < 0 ? times.length - 1 : Math.max(0, after - 1);
  const next = Math.min(times.length - 1, index + 1);
  const step = times[next] - times[index];
  return {index, next, step, share: step > 0 ? Math.max(0, (kt - times[index]) / step) : 0};
}

/// Positions at kt, by the cubic polynomial through the positions and velocities at both neighbouring times: a capsule
/// that turns by a right angle from one shape to the next keeps its size.
export function positions_at(shapes, kt) {
  const {index, next, step, share: s} = place_in(shapes.times, kt);
  const [x0, x1] = [shapes.positions[index], shapes.positions[next]];
  const [v0, v1] = [shapes.velocities[index], shapes.velocities[next]];
  const [a, b] = [(1 + 2 * s) * (1 - s) ** 2, s ** 2 * (3 - 2 * s)];
  const [c, d] = [step * s * (1 - s) ** 2, step * s ** 2 * (s - 1)];
  return x0.map((x, i) => a * x + b * x1[i] + c * v0[i] + d * v1[i]);
}

/// Numbers at the vertices at kt, linear in time. \param rows  one for each time
export function numbers_at(times, rows, kt) {
  const {index, next, share} = place_in(times, kt);
  return rows[index].map((number, i) => (1 - share) * number + share * rows[next][i]);
}
