// Numbers as colours that differ in lightness, too: some stops of matplotlib's viridis (CC0).

const kStops = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];

/// \param share  from 0 to 1   \return red, green, blue from 0 to 1
export function colour_at(share) {
  const place = Math.min(1, Math.max(0, share)) * (kStops.length - 1);
  const stop = Math.min(kStops.length - 2, Math.floor(place));
  return kStops[stop].map((from, i) => (from + (place - stop) * (kStops[stop + 1][i] - from)) / 255);
}

export const gradient = () => `linear-gradient(to right, ${kStops.map((stop) => `rgb(${stop})`).join(", ")})`;
