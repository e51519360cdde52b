// What the page shows, as the fragment of its address: #study=fig17-0308&case=a1b2&x=Ca&y=V&at=E_b=0.015&range=0.1,0.5,1,4.
// Such an
// address can be passed on.

export function read_link() {
  const parameters = new URLSearchParams(location.hash.slice(1));
  return {
    study: parameters.get("study"),
    cases: parameters.getAll("case"),
    x: parameters.get("x"),
    y: parameters.get("y"),
    at: parameters.getAll("at"),
    range: parameters.get("range"),
  };
}

export function link_to({study, cases = [], x = null, y = null, at = [], range = null}) {
  const parameters = new URLSearchParams();
  if (study) parameters.append("study", study);
  if (x) parameters.append("x", x);
  if (y) parameters.append("y", y);
  for (const value of at) parameters.append("at", value);
  if (range) parameters.append("range", range);
  for (const id of cases) parameters.append("case", id);
  return "#" + parameters;
}

/// Changes the address, and with it what the page shows.
export function go_to(shown) {
  location.hash = link_to(shown);
}
