// A rectangle that is drawn with the mouse over a picture.
import {svg_element} from "./elements.js";

const kMinSize = 12;  // below, the mouse was only clicked

export class Brush {
  /// \param picture  SVG   \param frame  {left, right, top, bottom}: the rectangle stays within
  /// \param ended({left, right, top, bottom})  called with the rectangle
  constructor(picture, frame, ended) {
    this.picture = picture;
    this.frame = frame;
    this.ended = ended;
    this.has_just_ended = false;  // until the click that follows has been handled
    this.area = svg_element("rect", {class: "brush", "pointer-events": "none", "aria-hidden": "true"});
    picture.addEventListener("pointerdown", (event) => this.begin(event));
    picture.addEventListener("pointermove", (event) => this.draw(event));
    picture.addEventListener("pointerup", (event) => this.end(event));
  }

  place_at(event) {
    const {left, right, top, bottom} = this.frame;
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.picture.getScreenCTM().inverse());
    return {x: Math.min(right, Math.max(left, at.x)), y: Math.min(bottom, Math.max(top, at.y))};
  }

  begin(event) {
    this.has_just_ended = false;
    if (event.pointerType === "mouse" && event.button === 0) this.from = this.place_at(event);
  }

  rectangle(event) {
    const to = this.place_at(event);
    return {left: Math.min(this.from.x, to.x), right: Math.max(this.from.x, to.x),
            top: Math.min(this.from.y, to.y), bottom: Math.max(this.from.y, to.y)};
  }

  draw(event) {
    if (!this.from) return;
    const {left, right, top, bottom} = this.rectangle(event);
    for (const [name, value] of Object.entries({x: left, y: top, width: right - left, height: bottom - top}))
      this.area.setAttribute(name, value);
  }

  end(event) {
    if (!this.from) return;
    const area = this.rectangle(event);
    this.from = null;
    this.area.setAttribute("width", 0);
    if (area.right - area.left < kMinSize || area.bottom - area.top < kMinSize) return;
    this.has_just_ended = true;
    this.ended(area);
  }
}
