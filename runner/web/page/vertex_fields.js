// What the capsule is coloured by: one number at each vertex.

const length_of = (vectors, vertex) => Math.hypot(vectors[3 * vertex], vectors[3 * vertex + 1], vectors[3 * vertex + 2]);

const lengths = (vectors) => Float32Array.from({length: vectors.length / 3}, (_, vertex) => length_of(vectors, vertex));

/// A third of the area of the triangles around each vertex.
function vertex_areas(positions, triangles) {
  const areas = new Float32Array(positions.length / 3);
  const side = (from, to, axis) => positions[3 * to + axis] - positions[3 * from + axis];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = triangles.subarray(t, t + 3);
    const [u, v] = [b, c].map((corner) => [0, 1, 2].map((axis) => side(a, corner, axis)));
    const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    for (const corner of [a, b, c]) areas[corner] += Math.hypot(...normal) / 6;
  }
  return areas;
}

function force_densities({positions, forces, triangles}) {
  return forces.map((row, i) => {
    const areas = vertex_areas(positions[i], triangles);
    return lengths(row).map((force, vertex) => force / areas[vertex]);
  });
}

/// The fields that the shapes have: [{name, words, rows}], with one row of numbers for each time.
export function fields_of(shapes) {
  const fields = [
    {name: "velocity", words: "speed / (a k)", rows: shapes.velocities.map(lengths)},
    {name: "force", words: "force of the membrane / (area μ_a k)", rows: force_densities(shapes)},
  ];
  if (shapes.stretches) fields.push({name: "stretch", words: "larger principal stretch", rows: shapes.stretches});
  return fields;
}

/// The smallest and largest number, over all times.
export function range_of(rows) {
  let [low, high] = [Infinity, -Infinity];
  for (const row of rows) for (const number of row) [low, high] = [Math.min(low, number), Math.max(high, number)];
  return [low, high];
}
