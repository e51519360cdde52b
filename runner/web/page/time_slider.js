// The time that capsules, curves and the path of Q show: a slider, and a button that lets it run.
import {element, set_text} from "./elements.js";
import {number_words} from "./words.js";

const kSpeed = 2;    // shear times in a second
const kStep = 0.05;  // of the slider

export class TimeSlider {
  /// \param change(kt)  called when the time changes
  constructor(change) {
    this.change = change;
    this.slider = element("input", {type: "range", min: 0, step: kStep, "aria-label": "shear time kt",
                                    input: () => this.set(Number(this.slider.value))});
    this.button = element("button", {click: () => this.toggle(), "aria-pressed": false}, "Play");
    this.words = element("output");
    this.place = element("div", {class: "time"}, this.button, this.slider, this.words);
    this.kt = 0;
  }

  /// \param end  of the longest history. The time stays within it.
  set_end(end) {
    this.end = end;
    this.slider.max = end;
    this.set(Math.min(this.kt, end));
  }

  set(kt) {
    this.kt = kt;
    this.slider.value = kt;
    this.slider.setAttribute("aria-valuetext", `kt = ${number_words(kt, 3)}`);
    set_text(this.words, `kt = ${kt.toFixed(2)}`);
    this.change(kt);
  }

  toggle() {
    this.before = this.before ? null : performance.now();
    const runs = Boolean(this.before);
    set_text(this.button, runs ? "Pause" : "Play");
    this.button.setAttribute("aria-pressed", runs);
    if (runs) requestAnimationFrame((now) => this.go_on(now));
  }

  go_on(now) {
    if (!this.before || !this.place.isConnected) return;
    const kt = this.kt + (kSpeed * Math.max(0, now - this.before)) / 1000;
    this.before = now;
    this.set(kt > this.end ? 0 : kt);
    requestAnimationFrame((next) => this.go_on(next));
  }
}
