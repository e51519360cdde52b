// The capsule of one case in three dimensions, to be turned by mouse, touch or keys.
import {save_blob} from "./download.js";
import {element} from "./elements.js";
import {numbers_at, positions_at} from "./shapes.js";
import {number_words} from "./words.js";

const kTurn = 0.15;          // radian, of one key press
const kPixelTurn = 0.01;     // radian, of one pixel
const kMagnification = 1.2;  // of one key press
const kKeys = {
  ArrowLeft: (scene) => scene.rotate(-kTurn, 0),
  ArrowRight: (scene) => scene.rotate(kTurn, 0),
  ArrowUp: (scene) => scene.rotate(0, kTurn),
  ArrowDown: (scene) => scene.rotate(0, -kTurn),
  "+": (scene) => scene.magnify(kMagnification),
  "-": (scene) => scene.magnify(1 / kMagnification),
  Home: (scene) => scene.look_from_the_front(),
};

export class CapsuleView {
  /// \param scene  CapsuleScene   \param shapes  as load_shapes returns them
  constructor({shown, title, colour}, scene, shapes) {
    this.scene = scene;
    this.shapes = shapes;
    this.title = title;
    this.canvas = element("canvas", {class: "capsule", role: "img", tabindex: 0});
    const line = element("span", {class: "line", "aria-hidden": "true"});
    line.style.background = colour;
    const picture = element("button", {click: () => this.save_picture(shown.id)}, "PNG");
    this.place = element("figure", {}, this.canvas, element("figcaption", {}, line, ` ${title} `, picture));
    this.listen();
  }

  listen() {
    this.canvas.addEventListener("keydown", (event) => {
      const act = kKeys[event.key];
      if (!act) return;
      event.preventDefault();
      act(this.scene);
      this.draw();
    });
    this.canvas.addEventListener("pointerdown", (event) => this.canvas.setPointerCapture(event.pointerId));
    this.canvas.addEventListener("pointermove", (event) => {
      if (!this.canvas.hasPointerCapture(event.pointerId)) return;
      this.scene.rotate(-kPixelTurn * event.movementX, kPixelTurn * event.movementY);
      this.draw();
    });
    this.canvas.addEventListener("dblclick", () => (this.scene.look_from_the_front(), this.draw()));
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  /// \param field  as fields_of returns it   \param range  of its colours
  show(kt, field, range) {
    const {times} = this.shapes;
    const shown = Math.min(kt, times.at(-1));
    this.scene.set_shape(positions_at(this.shapes, shown), numbers_at(times, field.rows, shown), range);
    this.canvas.setAttribute("aria-label",
      `Capsule, ${this.title}, at kt = ${number_words(shown)}. Arrow keys turn it, + and - magnify, Home looks along z.`);
    this.canvas.dataset.kt = shown;
    this.draw();
  }

  draw() {
    const size = Math.round(this.canvas.clientWidth * devicePixelRatio);
    if (size === 0) return;
    if (this.canvas.width !== size) this.canvas.width = this.canvas.height = size;
    this.scene.draw(this.canvas);
  }

  save_picture(id) {
    this.canvas.toBlob((blob) => save_blob(blob, `${id}_kt${this.canvas.dataset.kt}.png`));
  }
}
