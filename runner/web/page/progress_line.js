// The state of a study in one line: bar, counts, time left.
import {element, set_text} from "./elements.js";
import {time_left} from "./time_left.js";
import {count_words, duration_words, study_state_words} from "./words.js";

export class ProgressLine {
  constructor() {
    this.bar = element("progress", {max: 1, "aria-label": "progress"});
    this.words = element("span");
    this.line = element("span", {class: "progress"}, this.bar, this.words);
  }

  show(study) {
    this.bar.value = study.progress;
    const left = time_left(study);
    const words = [study_state_words(study.state), count_words(study.cases)];
    if (left !== null) words.push(`${duration_words(left)} left`);
    set_text(this.words, words.join("; "));
  }
}
