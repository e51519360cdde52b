// Motions, states, numbers and durations as the page writes them.

const kMotions = {
  tumbling: "tumbling",
  tank_treading: "tank-treading",
  transition: "transition",
  undecided: "undecided",
  mixed: "cases that differ",
};

const kCaseStates = {
  queued: "waiting",
  running: "running",
  done: "done",
  failed: "failed",
  diverged: "diverged: no answer",
  cancelled: "cancelled",
  mixed: "in different states",
};

const kStudyStates = {
  queued: "waiting to start",
  running: "running",
  paused: "paused",
  done: "finished",
  cancelled: "cancelled",
};

export const motion_words = (motion) => kMotions[motion] ?? motion;
export const study_state_words = (state) => kStudyStates[state] ?? state;

/// What is known of a point: its motion and whether it is confirmed, or else its state.
export function answer_words({motion, state, confirmed}) {
  if (!motion) return kCaseStates[state] ?? state;
  return motion_words(motion) + (confirmed ? ", confirmed" : ", not confirmed");
}

export function number_words(value, digits = 4) {
  return String(Number(value.toPrecision(digits)));
}

/// A value of a parameter: a number, a word, or a fidelity that is an object.
export function value_words(value) {
  return typeof value === "object" && value !== null ? JSON.stringify(value) : String(value);
}

export function duration_words(seconds) {
  if (seconds < 100) return `${Math.round(seconds)} s`;
  const minutes = Math.round(seconds / 60);
  return minutes < 100 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}

/// "37 of 96 cases, 2 running, 1 failed"
export function count_words(cases) {
  const ended = cases.total - cases.queued - cases.running;
  const others = ["running", "failed", "diverged", "cancelled"].filter((state) => cases[state] > 0);
  return [`${ended} of ${cases.total} cases`, ...others.map((state) => `${cases[state]} ${state}`)].join(", ");
}

export function sentence(text) {
  return text.charAt(0).toUpperCase() + text.slice(1) + (/[.!?]$/.test(text) ? "" : ".");
}
