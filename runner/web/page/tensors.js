// Arrays of numbers in one answer (schema/shapes.md): the size of a header, the header as JSON, the numbers.

const kTypes = {F64: Float64Array, F32: Float32Array, U32: Uint32Array};

/// \return {notes: {first: "0", ..}, arrays: {positions: {shape: [31, 642, 3], numbers}, ..}}
export function read_tensors(buffer) {
  const size = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, size)));
  const {__metadata__: notes, ...described} = header;
  const arrays = {};
  for (const [name, {dtype, shape, data_offsets: [begin, end]}] of Object.entries(described)) {
    const Type = kTypes[dtype];
    arrays[name] = {shape, numbers: new Type(buffer, 8 + size + begin, (end - begin) / Type.BYTES_PER_ELEMENT)};
  }
  return {notes, arrays};
}
