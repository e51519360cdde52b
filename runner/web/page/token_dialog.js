// Asks for the server's token.
import {element} from "./elements.js";

/// \param refused  whether the server has refused a token before
export function ask_for_token(refused) {
  const field = element("input", {type: "password", id: "token", autocomplete: "off", required: true});
  const dialog = element(
    "dialog", {"aria-labelledby": "token-label"},
    element("form", {method: "dialog"},
      element("label", {for: "token", id: "token-label"},
        refused ? "The server refuses this token. Another one:" : "This server wants a token (CAPSTAN_TOKEN):"),
      field, element("button", {}, "Go on")));
  document.body.append(dialog);
  dialog.addEventListener("cancel", (event) => event.preventDefault());
  dialog.showModal();
  return new Promise((resolve) => {
    dialog.querySelector("form").addEventListener("submit", (event) => {
      event.preventDefault();
      dialog.remove();
      resolve(field.value.trim());
    });
  });
}
