// The time that a study still needs, from the progress since the page has been looking.

const kMinGain = 1e-3;  // of the progress, before there is an answer

const begins = new Map();

/// Seconds, or null before enough is known.
export function time_left(study, now = performance.now() / 1000) {
  if (study.state !== "running") {
    begins.delete(study.id);
    return null;
  }
  const begin = begins.get(study.id) ?? {progress: study.progress, time: now};
  begins.set(study.id, begin);
  const gain = study.progress - begin.progress;
  return gain < kMinGain ? null : ((now - begin.time) * (1 - study.progress)) / gain;
}
