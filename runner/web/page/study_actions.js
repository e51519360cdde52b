// What can be done with a study: pause, resume, cancel, retry, delete.
import {element} from "./elements.js";
import {go_to} from "./link.js";
import {post, remove} from "./server.js";

const kActions = [
  {
    words: "Pause",
    fits: ({state}) => ["queued", "running"].includes(state),
    act: (path) => post(`${path}/pause`),
  },
  {words: "Resume", fits: ({paused}) => paused, act: (path) => post(`${path}/resume`)},
  {
    words: "Cancel",
    fits: ({state}) => ["queued", "running", "paused"].includes(state),
    question: "Cancel the cases that are not computed yet?",
    act: (path) => post(`${path}/cancel`),
  },
  {
    words: "Try failed cases again",
    fits: ({cases, cancelled}) => cases.failed > 0 && !cancelled,
    act: (path) => post(`${path}/retry`),
  },
  {
    words: "Delete",
    fits: () => true,
    question: "Delete the study, with the results of all cases that no other study wants? This cannot be undone.",
    act: (path) => remove(path).then(() => go_to({})),
  },
];

export class StudyActions {
  /// \param done(error)  called after an action, with the error if it was refused
  constructor(done) {
    this.done = done;
    this.place = element("div", {class: "actions", role: "group", "aria-label": "Change the study"});
    this.buttons = kActions.map((action) => element("button", {click: () => this.run(action)}, action.words));
    this.place.append(...this.buttons);
  }

  show(study) {
    this.study = study;
    kActions.forEach((action, i) => { this.buttons[i].hidden = !action.fits(study); });
  }

  async run({question, act}) {
    if (question && !confirm(`${this.study.name}: ${question}`)) return;
    await act(`/v1/studies/${encodeURIComponent(this.study.id)}`).then(() => this.done(null), this.done);
  }
}
