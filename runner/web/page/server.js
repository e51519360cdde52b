// Requests to the server that the page comes from. If the server wants a token, the page asks for it once and keeps it
// until the tab is closed.
import {ask_for_token} from "./token_dialog.js";

const kTokenKey = "capstan-token";

/// An answer that is an error: its text, and the issues of what was sent.
export class Refusal extends Error {
  constructor(status, problem) {
    super(problem.detail ?? `the server answered ${status}`);
    this.status = status;
    this.issues = problem.errors ?? [];
  }
}

let asking = null;

function new_token() {
  const refused = sessionStorage.getItem(kTokenKey) !== null;
  asking ??= ask_for_token(refused).then((token) => {
    sessionStorage.setItem(kTokenKey, token);
    asking = null;
  });
  return asking;
}

export const has_token = () => sessionStorage.getItem(kTokenKey) !== null;

/// The response, if it is no error. The browser keeps answers and asks whether they have changed.
export async function request(path, options = {}) {
  const token = sessionStorage.getItem(kTokenKey);
  const headers = {...options.headers, ...(token && {Authorization: `Bearer ${token}`})};
  const response = await fetch(path, {cache: "no-cache", ...options, headers});
  if (response.status === 401) {
    if (token === sessionStorage.getItem(kTokenKey)) await new_token();
    return request(path, options);
  }
  if (response.ok) return response;
  throw new Refusal(response.status, await response.json().catch(() => ({})));
}

export async function get(path) {
  return (await request(path)).json();
}

export async function post(path, text = "") {
  const headers = text ? {"Content-Type": "application/json"} : {};
  return (await request(path, {method: "POST", body: text || undefined, headers})).json();
}

export async function remove(path) {
  return (await request(path, {method: "DELETE"})).json();
}
