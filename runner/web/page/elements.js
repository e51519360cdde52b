// Builds elements of the page: element("p", {class: "note"}, "text", child).

function fill(made, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(name, value);
    else if (value === true) made.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, value);
  }
  made.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return made;
}

/// An attribute whose value is a function is a listener to the event of that name; false and null are left out.
export function element(name, attributes = {}, ...children) {
  return fill(document.createElement(name), attributes, children);
}

export function svg_element(name, attributes = {}, ...children) {
  return fill(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children);
}

/// Replaces the text only if it differs: screen readers announce every replacement in a status line.
export function set_text(place, text) {
  if (place.textContent !== text) place.textContent = text;
}
