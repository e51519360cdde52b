// Pictures of the page as files, in the colours that they have on it.
import {save_blob} from "./download.js";
import {svg_element} from "./elements.js";

const kProperties = ["display", "fill", "fill-opacity", "font-family", "font-size", "font-style", "stroke", "stroke-width", "vector-effect"];

const back = () => getComputedStyle(document.body).backgroundColor;

/// Gives each element of the copy the look of its original as attributes: a file has no style sheet.
function keep_look(original, copy) {
  const style = getComputedStyle(original);
  for (const property of kProperties) copy.setAttribute(property, style.getPropertyValue(property));
  for (const name of ["class", "tabindex", "role"]) copy.removeAttribute(name);
  [...original.children].forEach((child, i) => keep_look(child, copy.children[i]));
}

/// \param picture  an SVG element of the page with a viewBox
export function save_svg(picture, name) {
  const copy = picture.cloneNode(true);
  keep_look(picture, copy);
  const {x, y, width, height} = picture.viewBox.baseVal;
  copy.setAttribute("width", width);
  copy.setAttribute("height", height);
  copy.prepend(svg_element("rect", {x, y, width, height, fill: back()}));
  save_blob(new Blob([new XMLSerializer().serializeToString(copy)], {type: "image/svg+xml"}), name);
}

/// \param canvas  transparent where nothing is drawn
export function save_png(canvas, name) {
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext("2d");
  context.fillStyle = back();
  context.fillRect(0, 0, copy.width, copy.height);
  context.drawImage(canvas, 0, 0);
  copy.toBlob((blob) => save_blob(blob, name));
}
