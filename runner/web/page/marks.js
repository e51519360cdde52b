// The marks of a phase diagram, as `capstan figure` draws them. A motion that is not confirmed has an open mark.

/// Outlines for a mark of radius 1 around 0.
const kSquare = "M-.85-.85H.85V.85H-.85Z";
const kCircle = "M-1 0A1 1 0 1 1 1 0A1 1 0 1 1-1 0Z";
const kTriangle = "M0-1.1L1.05.8H-1.05Z";
const kDiamond = "M0-1.2L1.2 0L0 1.2L-1.2 0Z";
const kPlus = "M-1 0H1M0-1V1";
const kCross = "M-.8-.8L.8.8M-.8.8L.8-.8";
const kDot = "M-.4 0A.4.4 0 1 1 .4 0A.4.4 0 1 1-.4 0Z";

const kOutlines = {
  tumbling: kSquare,
  tank_treading: kCircle,
  transition: kTriangle,
  undecided: kDiamond,
  mixed: kPlus,
  diverged: kCross,
  failed: kCross,
};

/// The name of the mark: a motion, or the state of a point without one.
export const mark_of = (cell) => cell.motion ?? cell.state;

export const outline_of = (mark) => kOutlines[mark] ?? kDot;

/// Classes for page.css, which has the colours.
export function mark_classes(cell) {
  const open = cell.motion && !cell.confirmed ? " open" : "";
  return `mark ${mark_of(cell)}${open}`;
}
