// One study: progress, actions, phase diagram or list of cases, and the cases that are open.
import {axes_of, axis_menus, diagram_path, has_diagram} from "./axis_choice.js";
import {boundary_words} from "./boundary.js";
import {CaseList} from "./case_list.js";
import {study_of_case, submit_case} from "./case_study.js";
import {Diagram} from "./diagram.js";
import {download_link} from "./download.js";
import {element, set_text} from "./elements.js";
import {go_to, read_link} from "./link.js";
import {OpenCases} from "./open_cases.js";
import {PointDialog, rounded} from "./point_dialog.js";
import {ProgressLine} from "./progress_line.js";
import {save_svg} from "./save_picture.js";
import {get} from "./server.js";
import {StudyActions} from "./study_actions.js";

const kMaxPage = 1000;     // cases in one answer
const kShapesEvery = 0.5;  // kt: between two shapes a capsule turns by less than a right angle

/// [first, last] of x and y, or null.
function ranges_of({range}) {
  const [x0, x1, y0, y1] = (range ?? "").split(",").map(Number);
  return x0 < x1 && y0 < y1 ? [[x0, x1], [y0, y1]] : null;
}

export class StudyView {
  /// \param study    as it is now
  /// \param changed  called after an action, with the error if it was refused
  constructor(study, changed) {
    this.id = study.id;
    this.progress = new ProgressLine();
    this.actions = new StudyActions(changed);
    const open = (cell, adds) => this.open(cell.cases, adds);
    const magnify = (ranges) => go_to({...read_link(), range: ranges?.flat().map(rounded).join(",")});
    this.points = has_diagram(study) ? new Diagram(open, (place, nearest) => this.compute(place, nearest), magnify)
                                     : new CaseList(open);
    this.dialog = new PointDialog(({id}) => this.open_cases_of(id, read_link().cases));
    this.boundary = element("p", {class: "hint", role: "status"});
    const another = element("button", {click: () => this.points.compute_in_the_middle()}, "Compute another point …");
    this.menus = element("div", {class: "menus"});
    this.opened = new OpenCases((id) => this.close(id), (shown) => this.compute_shapes(shown));
    this.hint = element("p", {class: "hint"});
    this.files = element("p", {class: "files"});
    this.place = element("article", {},
      element("h2", {}, study.name || study.id), element("p", {}, study.description),
      ...study.notes.map((note) => element("p", {class: "hint"}, note)),
      element("p", {}, this.progress.line), this.actions.place, this.menus,
      element("div", {class: "split"}, element("div", {}, this.points.place, this.boundary, has_diagram(study) ? another : null, this.hint), this.opened.place), this.files);
  }

  async show(study, link) {
    this.study = study;
    this.progress.show(study);
    this.actions.show(study);
    await (has_diagram(study) ? this.show_diagram(study, link) : this.show_list(study, link));
    await this.show_boundary(study);
    set_text(this.hint, "Choose a point to see why it has its label; with Shift, it is shown beside those that are open. " +
      (has_diagram(study) ? "A click between the points computes one there; a rectangle drawn with the mouse is magnified." : ""));
    await this.opened.show(link.cases, study.axes.filter(({values}) => values.length > 1).map((axis) => axis.parameter));
    if (has_diagram(study)) this.points.show_others(this.others());
  }

  /// Asks for the diagram again only if the study has changed.
  async show_diagram(study, link) {
    const axes = axes_of(study, link);
    const path = diagram_path(study, axes);
    const text = JSON.stringify([path, study.state, study.cases, study.motions]);
    if (text !== this.text) this.diagram = await get(path);
    if (path !== this.path) {
      const change = (chosen) => go_to({...read_link(), ...chosen});
      this.menus.replaceChildren(...axis_menus(study, axes, change));
      this.show_files(study, path);
    }
    this.text = text;
    this.path = path;
    this.points.show(this.diagram, link.cases, ranges_of(link));
  }

  async show_boundary(study) {
    if (!study.links.boundary) return;
    const boundary = await get(study.links.boundary);
    if (has_diagram(study)) this.points.show_boundary(boundary);
    set_text(this.boundary, boundary_words(boundary));
  }

  /// Open cases that stand at a place of the diagram but are no points of the study.
  others() {
    const {x, y, at, rows} = this.diagram;
    const points = new Set(rows.flat().flatMap(({cases}) => cases));
    return this.opened.cases_shown
      .filter(({shown: {id, parameters}}) => !points.has(id) && typeof parameters[x.parameter] === "number" &&
        typeof parameters[y.parameter] === "number" &&
        Object.entries(at).every(([name, value]) => typeof value !== "number" || parameters[name] === value))
      .map(({shown}) => ({...shown, x: shown.parameters[x.parameter], y: shown.parameters[y.parameter]}));
  }

  /// \param nearest  id of the nearest case, whose other parameters are taken
  async compute(place, nearest) {
    if (!nearest) return;
    const {parameters} = await get(`/v1/cases/${encodeURIComponent(nearest)}`);
    this.dialog.open(this.study, place, parameters);
  }

  /// Computes a case again with its shapes, and shows that in its place.
  async compute_shapes({id, parameters}) {
    const base = {...parameters, outputs: {...parameters.outputs, shapes_every: kShapesEvery}};
    const study = study_of_case(this.study, "shapes", `Case ${id} of ${this.study.id}, with its shapes.`, base);
    await submit_case(study, (submitted) => this.open_cases_of(submitted.id, read_link().cases.filter((other) => other !== id)));
  }

  /// Shows the cases of another study. \param others  ids of the cases that are shown before them
  async open_cases_of(id, others) {
    const {cases} = await get(`/v1/studies/${encodeURIComponent(id)}/cases`);
    go_to({...read_link(), cases: [...others, ...cases.map((item) => item.id)]});
  }

  async show_list(study, link) {
    await this.points.show(study, link.cases);
    if (!this.files.hasChildNodes()) this.show_files(study, null);
  }

  show_files(study, diagram) {
    const path = `/v1/studies/${encodeURIComponent(study.id)}`;
    const cases = study.points > kMaxPage ? `first ${kMaxPage} cases (JSON)` : "cases (JSON)";
    const files = [["study (JSON)", path, ".json"], ["cases (CSV)", `${path}/cases?format=csv`, "_cases.csv"],
                   [cases, `${path}/cases?limit=${kMaxPage}`, "_cases.json"]];
    if (diagram)
      files.push(["phase diagram (CSV)", `${diagram}&format=csv`, "_diagram.csv"], ["phase diagram (JSON)", diagram, "_diagram.json"]);
    if (study.links.boundary)
      files.push(["boundary (CSV)", `${study.links.boundary}?format=csv`, "_boundary.csv"], ["boundary (JSON)", study.links.boundary, "_boundary.json"]);
    const picture = element("button", {click: () => save_svg(this.points.picture, `${study.id}_diagram.svg`)}, "phase diagram (SVG)");
    this.files.replaceChildren("Download: ",
      ...files.flatMap(([words, address, end]) => [download_link(words, address, study.id + end), " "]), ...(diagram ? [picture] : []));
  }

  open(ids, adds) {
    const link = read_link();
    const others = adds ? link.cases.filter((id) => !ids.includes(id)) : [];
    const is_closed = adds && ids.every((id) => link.cases.includes(id));
    go_to({...link, cases: is_closed ? others : [...others, ...ids]});
  }

  close(id) {
    const link = read_link();
    go_to({...link, cases: link.cases.filter((other) => other !== id)});
  }
}
