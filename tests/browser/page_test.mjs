// The page in Chromium, with real daemons. Run by tests/browser.sh, which sets the environment:
//   CAPSTAN, FAKE_CAPSTAN   the program, and the program with the fake solver of tests/support
//   BROWSER                 Chromium
//   WORK                    an empty directory
import assert from "node:assert/strict";
import {spawn} from "node:child_process";
import {once} from "node:events";
import {readFile, writeFile} from "node:fs/promises";
import {after, before, test} from "node:test";
import {chromium} from "playwright-core";

const {CAPSTAN, FAKE_CAPSTAN, BROWSER, WORK} = process.env;
const kPatience = 60000;  // milliseconds, on a busy machine
const daemons = [];       // also those of failed tests

/// Starts a daemon. \return {url, stop}
async function serve(program, name, {port = 0, token} = {}) {
  const {CAPSTAN_TOKEN, ...environment} = process.env;
  const daemon = spawn(program, ["serve", "--data", `${WORK}/${name}`, "--listen", `127.0.0.1:${port}`, "--cores", "1"],
    {env: token ? {...environment, CAPSTAN_TOKEN: token} : environment, stdio: ["ignore", "pipe", "inherit"]});
  daemons.push(daemon);
  let said = "";
  for await (const text of daemon.stdout) {
    said += text;
    if (/http:\/\/[\d.:]+/.test(said)) break;
  }
  const [url] = /http:\/\/[\d.:]+/.exec(said);
  const stop = async () => {
    daemon.kill("SIGTERM");
    await once(daemon, "exit");
  };
  return {url, port: Number(new URL(url).port), stop};
}

async function submit(url, study) {
  for (;;) {
    const answer = await fetch(`${url}/v1/studies`, {method: "POST", body: JSON.stringify(study), headers: {"Content-Type": "application/json"}});
    if (answer.ok) return (await answer.json()).id;
    if (answer.status !== 503) assert.fail(await answer.text());  // 503: the daemon is starting
  }
}

const study = (name, axes, base = {}) => ({name, base: {shape: "biconcave", law: "skalak", C: 5, E_b: 0.015, fluid: "stokes",
                                                        until: {kt: 10}, fidelity: "fast", ...base}, axes});

let browser;
let fake;
const faults = [];

async function open(address, options = {}) {
  const context = await browser.newContext({viewport: {width: 1200, height: 900}, acceptDownloads: true, ...options});
  const page = await context.newPage();
  page.setDefaultTimeout(kPatience);
  page.on("pageerror", (error) => faults.push(error.stack));
  page.on("console", (message) => {
    if (/Refused|violates|Uncaught/.test(message.text())) faults.push(message.text());
  });
  page.on("dialog", (dialog) => dialog.accept());
  await page.goto(address);
  return page;
}

const close = (page) => page.context().close();
const text_of = (page, selector) => page.locator(selector).first().textContent();

before(async () => {
  browser = await chromium.launch({executablePath: BROWSER, args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]});
  fake = await serve(FAKE_CAPSTAN, "fake");
});

after(async () => {
  await browser.close();
  for (const daemon of daemons) daemon.kill("SIGTERM");
});

test("a study that is checked and submitted in the form appears and is computed", async () => {
  const page = await open(fake.url);
  await page.getByText("There are no studies yet").waitFor();
  await page.getByText("New study").click();
  await page.locator("#study-text").fill(JSON.stringify(study("form", {Ca: [0.1, 1], V: [1, 10]})));
  await page.getByRole("button", {name: "Check"}).click();
  await page.getByText(/Valid: 4 cases, about/).waitFor();
  await page.getByRole("button", {name: "Submit"}).click();
  await page.getByText("finished; 4 of 4 cases").first().waitFor();
  await page.getByRole("button", {name: "Ca = 0.1, V = 10: tumbling, confirmed"}).waitFor();
  await page.getByRole("button", {name: "Ca = 1, V = 1: tank-treading, confirmed"}).waitFor();
  await close(page);
});

test("an invalid study is refused with each issue and its place", async () => {
  const page = await open(fake.url);
  await page.getByText("New study").click();
  await page.locator("#study-text").fill(JSON.stringify(study("invalid", {Ca: [-1]}, {V: -2})));
  await page.getByRole("button", {name: "Submit"}).click();
  await page.getByText(/\/axes\/Ca/).waitFor();
  await page.getByText(/\/base\/V/).waitFor();
  await close(page);
});

test("the diagram fills while the study runs", async () => {
  const id = await submit(fake.url, study("fill", {Ca: [0.1, 0.2], V: [1, 40]}));
  const page = await open(`${fake.url}/#study=${id}`);
  const running = page.getByRole("button", {name: /V = 40: running/}).first();
  await running.waitFor();
  await running.click();
  const case_id = /case=(\w+)/.exec(page.url())[1];
  await writeFile(`${WORK}/fake/runs/${case_id}/go`, "");
  await page.getByRole("button", {name: "Ca = 0.1, V = 40: tumbling, confirmed"}).waitFor();
  await page.getByRole("button", {name: "Cancel"}).click();
  await page.getByText(/cancelled; /).first().waitFor();
  await close(page);
});

test("two points are shown side by side, and the address shows them again", async () => {
  const id = await submit(fake.url, study("form", {Ca: [0.1, 1], V: [1, 10]}));
  const page = await open(`${fake.url}/#study=${id}`);
  await page.getByRole("button", {name: /Ca = 0.1, V = 10/}).click();
  await page.getByRole("button", {name: /Ca = 1, V = 1:/}).click({modifiers: ["Shift"]});
  await page.waitForFunction(() => document.querySelectorAll("section.case").length === 2);
  const other = await open(page.url());
  await other.waitForFunction(() => document.querySelectorAll("section.case").length === 2);
  assert.equal(await other.locator(".curve canvas").count(), 2);
  await other.getByText(/has recorded no shapes/).first().waitFor();
  await close(page);
  await close(other);
});

test("an address may have the name of a study", async () => {
  const id = await submit(fake.url, study("form", {Ca: [0.1, 1], V: [1, 10]}));
  const page = await open(`${fake.url}/#study=form&x=V`);
  await page.getByRole("button", {name: "V = 10, Ca = 0.1: tumbling, confirmed"}).waitFor();
  assert.match(page.url(), new RegExp(`study=${id}&x=V`));
  await close(page);
});

test("arrow keys move between the points and Enter opens one", async () => {
  const id = await submit(fake.url, study("form", {Ca: [0.1, 1], V: [1, 10]}));
  const page = await open(`${fake.url}/#study=${id}`);
  await page.getByRole("button", {name: /Ca = 0.1, V = 1:/}).focus();
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("Enter");
  await page.getByRole("region", {name: "Ca = 1, V = 10"}).waitFor();
  await close(page);
});

test("a diagram is downloaded as CSV", async () => {
  const id = await submit(fake.url, study("form", {Ca: [0.1, 1], V: [1, 10]}));
  const page = await open(`${fake.url}/#study=${id}`);
  const coming = page.waitForEvent("download");
  await page.getByRole("link", {name: "phase diagram (CSV)"}).click();
  const text = await readFile(await (await coming).path(), "utf8");
  assert.match(text, /^V,Ca,motion,confirmed,state,case\r\n1,0.1,tumbling,true,done,/);
  await close(page);
});

test("pictures are saved with the look that they have on the page", async () => {
  const id = await submit(fake.url, study("form", {Ca: [0.1, 1], V: [1, 10]}));
  const page = await open(`${fake.url}/#study=${id}`);
  await page.getByRole("button", {name: /Ca = 0.1, V = 10/}).click();
  const saved = async (name) => {
    const coming = page.waitForEvent("download");
    await page.getByRole("button", {name}).click();
    return readFile(await (await coming).path());
  };
  const diagram = (await saved("phase diagram (SVG)")).toString();
  assert.match(diagram, /^<svg [^>]*width="640"/);
  assert.match(diagram, /fill="rgb\(213, 94, 0\)"/);
  assert.doesNotMatch(diagram, /class=|var\(/);
  assert.match((await saved("path of Q (SVG)")).toString(), /D_xy cos 2θ/);
  assert.equal((await saved("D_xy over kt (PNG)")).subarray(1, 4).toString(), "PNG");
  await close(page);
});

test("a click between the points computes one there, once its cost has been shown", async () => {
  const id = await submit(fake.url, study("form", {Ca: [0.1, 1], V: [1, 10]}));
  const page = await open(`${fake.url}/#study=${id}`);
  await page.getByRole("button", {name: /Ca = 1, V = 1:/}).waitFor();
  const box = await page.locator("svg.diagram").boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await page.getByText(/It takes about .* of one core/).waitFor();
  await page.getByRole("spinbutton", {name: "Ca ="}).fill("0.4");
  await page.getByRole("spinbutton", {name: "V ="}).fill("5");
  await page.getByRole("button", {name: "Compute", exact: true}).click();
  await page.getByRole("img", {name: "Ca = 0.4, V = 5: tumbling, confirmed"}).waitFor();
  await close(page);
});

test("a rectangle drawn with the mouse is magnified, and the whole diagram comes back", async () => {
  const id = await submit(fake.url, study("form", {Ca: [0.1, 1], V: [1, 10]}));
  const page = await open(`${fake.url}/#study=${id}`);
  const marks = page.locator("svg.diagram [role=button]");
  await marks.first().waitFor();
  const box = await page.locator("svg.diagram").boundingBox();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.05 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.97 * box.width, box.y + 0.3 * box.height, {steps: 4});
  await page.mouse.up();
  await page.waitForFunction(() => document.querySelectorAll("svg.diagram [role=button]").length === 1);
  assert.match(page.url(), /range=/);
  await page.getByRole("button", {name: "Show the whole diagram"}).click();
  await page.waitForFunction(() => document.querySelectorAll("svg.diagram [role=button]").length === 4);
  await close(page);
});

test("failed cases say why and are tried again; a study is paused, resumed and deleted", async () => {
  const id = await submit(fake.url, study("fail", {Ca: [0.1, 1], V: [90, 70]}));
  const page = await open(`${fake.url}/#study=${id}`);
  await page.getByRole("button", {name: /V = 90: failed/}).first().click();
  await page.getByText("The solver refused the case").first().waitFor();
  await page.getByRole("button", {name: "Pause"}).click();
  await page.getByText(/paused; /).first().waitFor();
  await page.getByRole("button", {name: "Resume"}).click();
  await page.getByText(/running; /).first().waitFor();
  await page.getByRole("button", {name: "Try failed cases again"}).click();
  await page.getByRole("button", {name: "Delete"}).click();
  await page.waitForFunction((gone) => !document.querySelector(`#studies a[href*="${gone}"]`), id);
  await close(page);
});

test("ten thousand points are drawn once and can be reached and opened", async () => {
  const values = (first, step) => Array.from({length: 100}, (_, i) => Number((first + step * i).toFixed(4)));
  const id = await submit(fake.url, study("many", {Ca: values(0.01, 0.01), V: values(70, 0.01)}, {outputs: {history_every: 1}}));
  const page = await open(`${fake.url}/#study=${id}`);
  await page.waitForFunction(() => document.querySelectorAll("svg.diagram [role=button]").length === 10000);
  const mark = page.locator("svg.diagram [role=button]").nth(5050);
  await mark.evaluate((element) => { element.dataset.kept = "yes"; element.focus(); });
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await page.getByRole("region", {name: /Ca = /}).waitFor();
  assert.equal(await mark.getAttribute("data-kept"), "yes");
  await close(page);
  await fetch(`${fake.url}/v1/studies/${id}`, {method: "DELETE"});
});

test("a daemon that is restarted while the page is open is followed again", async () => {
  const first = await serve(FAKE_CAPSTAN, "restarted");
  const id = await submit(first.url, study("restarted", {Ca: [0.1, 1], V: [1, 10]}));
  const page = await open(`${first.url}/#study=${id}`);
  await page.getByText("finished; 4 of 4 cases").first().waitFor();
  await first.stop();
  await page.getByText("The server does not answer; trying again.").waitFor();
  const second = await serve(FAKE_CAPSTAN, "restarted", {port: first.port});
  await page.getByText("The server does not answer; trying again.").waitFor({state: "hidden"});
  const added = await submit(second.url, study("added", {Ca: [0.3]}));
  await page.locator(`#studies a[href*="${added}"]`).waitFor();
  await close(page);
  await second.stop();
});

test("a server with a token is asked nothing before the page has it; a wrong one is asked for again", async () => {
  const token = "0123456789abcdef";
  const guarded = await serve(FAKE_CAPSTAN, "restarted", {token});
  const page = await open(guarded.url);
  await page.getByRole("textbox", {name: "This server wants a token"}).fill("fedcba9876543210");
  await page.getByRole("button", {name: "Go on"}).click();
  await page.getByRole("textbox", {name: "The server refuses this token"}).fill(token);
  await page.getByRole("button", {name: "Go on"}).click();
  await page.getByText("finished; 4 of 4 cases").first().waitFor();
  const coming = page.waitForEvent("download");
  await page.getByRole("link", {name: "study (JSON)"}).click();
  assert.match(await readFile(await (await coming).path(), "utf8"), /"name": "added"/);
  await close(page);
  await guarded.stop();
});

test("a capsule is drawn, moves with the time and turns by the keys", async () => {
  const real = await serve(CAPSTAN, "real");
  const id = await submit(real.url, study("capsule", {Ca: [0.25]}, {V: 4, until: {kt: 3}, fidelity: {nodes: 162}, outputs: {shapes_every: 0.5}}));
  const page = await open(`${real.url}/#study=${id}`);
  await page.getByText("finished; 1 of 1 cases").first().waitFor();
  await page.locator("#point-1").click();
  const canvas = page.locator("canvas.capsule");
  await canvas.waitFor();
  const picture = () => canvas.evaluate((element) => element.toDataURL());
  await page.waitForFunction(() => document.querySelector("canvas.capsule").dataset.kt !== undefined);
  const pictures = [await picture()];
  await page.getByLabel("shear time kt").fill("2");
  pictures.push(await picture());
  await canvas.focus();
  await page.keyboard.press("ArrowRight");
  pictures.push(await picture());
  await page.getByLabel("Colour:").selectOption("stretch");
  pictures.push(await picture());
  assert.equal(new Set(pictures).size, 4);
  assert.match(await canvas.getAttribute("aria-label"), /at kt = 2\b/);
  await close(page);
  await real.stop();
});

test("a case without shapes is computed again with them, and shown in its place", async () => {
  const real = await serve(CAPSTAN, "shapes");
  const id = await submit(real.url, study("plain", {Ca: [0.25]}, {V: 4, until: {kt: 2}, fidelity: {nodes: 162}, outputs: {shapes_every: 0}}));
  const page = await open(`${real.url}/#study=${id}`);
  await page.getByText("finished; 1 of 1 cases").first().waitFor();
  await page.locator("#point-1").click();
  await page.getByRole("button", {name: "Compute its shapes"}).click();
  await page.locator("canvas.capsule").waitFor();
  assert.equal(await page.locator("section.case").count(), 1);
  await page.locator("#studies a", {hasText: "plain-shapes"}).waitFor();
  const [, case_id] = /case=(\w+)/.exec(page.url());
  const {parameters} = await (await fetch(`${real.url}/v1/cases/${case_id}`)).json();
  assert.equal(parameters.outputs.shapes_every, 0.5);
  assert.equal(parameters.Ca, 0.25);
  await close(page);
  await real.stop();
});

test("a boundary is found and drawn with its band and limits while the diagram is open", async () => {
  const real = await serve(CAPSTAN, "boundary");
  const {axes, ...sought} = study("boundary", {}, {until: {kt: 30}, fidelity: {nodes: 362}});
  const boundary = {along: "Ca", between: [0.1, 0.5], for: {V: [1, 2]}, tolerance: 0.05, explore: 3};
  const id = await submit(real.url, {...sought, boundary});
  const page = await open(`${real.url}/#study=${id}`);
  await page.getByText(/^Found\. V = 1: Ca = 0\.1\d+ \(.*V = 2: Ca = 0\.2\d+/).waitFor();
  const {curves: [{points}]} = await (await fetch(`${real.url}/v1/studies/${id}/boundary`)).json();
  assert.equal(points.length, 2);
  const corners = async (name) => (await page.locator(`svg path.${name}`).getAttribute("d")).match(/[ML]/g).length;
  assert.equal(await corners("boundary"), 2);
  assert.equal(await corners("bounds"), 4);
  assert.equal(await corners("band"), 4);
  await close(page);
  await real.stop();
});

test("a boundary of one row is drawn as a dot with its bar", async () => {
  const real = await serve(CAPSTAN, "row");
  const {axes, ...sought} = study("row", {}, {until: {kt: 30}, fidelity: {nodes: 362}});
  const boundary = {along: "Ca", between: [0.1, 0.5], for: {V: [2]}, tolerance: 0.05, explore: 3};
  const id = await submit(real.url, {...sought, boundary});
  const page = await open(`${real.url}/#study=${id}`);
  await page.getByText(/^Found\. V = 2: Ca = 0\.\d+/).waitFor();
  const boundary_of = (name) => page.locator(`svg path.${name}`).getAttribute("d");
  assert.match(await boundary_of("boundary.single"), /^M[\d. ]+h0$/);
  assert.equal((await boundary_of("bounds")).match(/[ML]/g).length, 2);
  await close(page);
  await real.stop();
});

test("a phone needs no scrolling sideways, and the dark scheme is dark", async () => {
  const id = await submit(fake.url, study("form", {Ca: [0.1, 1], V: [1, 10]}));
  const page = await open(`${fake.url}/#study=${id}`, {viewport: {width: 375, height: 700}, colorScheme: "dark"});
  await page.getByRole("button", {name: /Ca = 0.1, V = 10/}).click();
  await page.locator("section.case").waitFor();
  assert.match(await page.locator("section.case").textContent(), /Parameters.*Ca/);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(22, 22, 22)");
  await close(page);
});

test("no page had an error or broke its security policy", () => assert.deepEqual(faults, []));
