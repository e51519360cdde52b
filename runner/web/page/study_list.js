// The list of studies, the newest first.
import {element} from "./elements.js";
import {link_to} from "./link.js";
import {ProgressLine} from "./progress_line.js";

export class StudyList {
  constructor(place) {
    this.items = new Map();
    this.list = element("ul");
    this.empty = element("p", {hidden: true}, "There are no studies yet. Submit one below, or with: capstan submit FILE");
    place.append(element("h2", {}, "Studies"), this.empty, this.list);
  }

  /// Items are kept and moved, so that the one with the keyboard's focus keeps it.
  show(studies, chosen) {
    this.empty.hidden = studies.length > 0;
    const ids = new Set(studies.map((study) => study.id));
    for (const [id, item] of this.items) if (!ids.has(id)) item.row.remove(), this.items.delete(id);
    studies.forEach((study, place) => {
      const item = this.item_of(study);
      if (this.list.children[place] !== item.row) this.list.insertBefore(item.row, this.list.children[place] ?? null);
      item.progress.show(study);
      item.link.toggleAttribute("aria-current", study.id === chosen);
    });
  }

  item_of(study) {
    if (!this.items.has(study.id)) this.items.set(study.id, this.new_item(study));
    return this.items.get(study.id);
  }

  new_item(study) {
    const progress = new ProgressLine();
    const link = element("a", {href: link_to({study: study.id}), title: study.description || null}, study.name || study.id);
    return {progress, link, row: element("li", {}, link, progress.line)};
  }
}
