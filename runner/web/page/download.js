// Links to files. A browser does not send the token for a link, so with a token the page fetches the file itself.
import {element} from "./elements.js";
import {has_token, request} from "./server.js";

/// Saves bytes that the page has as a file.
export function save_blob(blob, name) {
  const address = URL.createObjectURL(blob);
  element("a", {href: address, download: name}).click();
  setTimeout(() => URL.revokeObjectURL(address), 10000);
}

const save = async (path, name) => save_blob(await (await request(path)).blob(), name);

export function download_link(words, path, name) {
  const click = (event) => {
    if (!has_token()) return;
    event.preventDefault();
    save(path, name).catch((error) => alert(error.message));
  };
  return element("a", {href: path, download: name, click}, words);
}
