// The page: the studies, one of them in detail, both up to date.
import {set_text} from "./elements.js";
import {link_to, read_link} from "./link.js";
import {get, Refusal} from "./server.js";
import {StudyList} from "./study_list.js";
import {StudyView} from "./study_view.js";
import {SubmitForm} from "./submit_form.js";

const kInterval = 1000;  // milliseconds between two looks at the server
const kShare = 9;        // times as long as a look takes: large studies must not keep server and browser busy
const kLongestPause = 5000;

const notice = document.getElementById("notice");
const studies_place = document.getElementById("studies");
const study_place = document.getElementById("study");
const list = new StudyList(studies_place);
studies_place.append(new SubmitForm().place);
let view = null;
let is_awake = false;  // whether to look again at once
let end_pause = () => {};

async function show_study(link) {
  if (view?.id !== link.study) {
    view = null;
    study_place.replaceChildren();
  }
  if (!link.study) return;
  const study = await get(`/v1/studies/${encodeURIComponent(link.study)}`);
  if (!view) {
    view = new StudyView(study, after_action);
    study_place.replaceChildren(view.place);
  }
  await view.show(study, link);
}

/// Links may name a study by its name or the beginning of its id, as the commands do.
async function id_of_study(word) {
  const {studies} = await get(`/v1/ids/${encodeURIComponent(word)}`);
  if (studies.length > 1) throw new Refusal(300, {detail: `"${word}" may be any of these studies: ${studies.join(", ")}`});
  return studies[0] ?? word;
}

async function look() {
  const {studies} = await get("/v1/studies?limit=100");
  if (!read_link().study && studies.length > 0) history.replaceState(null, "", link_to({study: studies[0].id}));
  const named = read_link();
  if (named.study && named.study !== view?.id)
    history.replaceState(null, "", link_to({...named, study: await id_of_study(named.study)}));
  const link = read_link();
  list.show(studies, link.study);
  await show_study(link);
}

function problem_words(error) {
  if (!(error instanceof Refusal)) return "The server does not answer; trying again.";
  if (error.status === 404) return `Not found: ${error.message}.`;
  return error.message;
}

function after_action(error) {
  if (error) alert(problem_words(error));
  else wake();
}

function wake() {
  is_awake = true;
  end_pause();
}

/// Ends after the interval, when the address changes, or after an action; while the page is hidden, when it is shown.
async function pause(milliseconds) {
  if (is_awake) return;
  await new Promise((resolve) => {
    const timer = setTimeout(() => document.hidden || resolve(), milliseconds);
    end_pause = () => (clearTimeout(timer), resolve());
  });
}

addEventListener("hashchange", wake);
document.addEventListener("visibilitychange", () => document.hidden || wake());

for (;;) {
  const begin = performance.now();
  is_awake = false;
  await look().then(() => set_text(notice, ""), (error) => set_text(notice, problem_words(error)));
  await pause(Math.min(Math.max(kInterval, kShare * (performance.now() - begin)), kLongestPause));
}
