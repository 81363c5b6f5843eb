// The connection to RayCaster in Web Workers. A worker does one thing at a time, so there are three: the camera turns at once while another one
// counts rays, and a diagnosis that takes too long ends with its worker.
import { $ } from "./dom.js";
import { cannot, fromLink, isLink } from "./link.js";
import { keep, kept, readdress } from "./memory.js";

const answers = { view: "Scene, Hover, Frame, Camera, Explanation", study: "Map, Comparison, Ledger", search: "Diagnosis" };
const workers = {};
const waiting = new Set(); // workers that have not begun
let isOpen = false; // whether a worker has said something
let isSearching = false; // whether a diagnosis runs
let isOver = false; // whether it has been told that none can start
let told = null;   // what to do with what the workers send
let mine = null;   // the user's picture: its name and its bytes

/** The name of the scene's file, and its text. */
export let scene = null;

/** By how much the first frame's sides are divided while the camera moves. */
export const firstDivisor = 4;

export async function connect(listener) {
  told = listener;
  let camera = null;
  if (!scene) {
    const { name, text, seenThrough = null } = await linked() ?? last() ?? await first();
    camera = seenThrough;
    change(name, text);
  }
  ["view", "study"].forEach(start);
  begin("view"); // the study begins after the first picture, which it would delay
  if (camera) told.camera(camera);
}

/** The scene in the page's address, which the page then leaves but for the pixel. */
async function linked() {
  const address = location.href;
  if (!isLink(address)) return null;
  readdress(new URL(location.hash ? location.pathname : ".", address)); // of a link whose "#" was encoded, all of it is the name of a file
  const link = cannot ? null : await fromLink(address);
  if (!link) $("notice").textContent = `${cannot ?? "This link is broken: it does not hold a whole scene."} Another scene is shown.`;
  else if (link.pixel) readdress(`#pixel=${link.pixel}`);
  return link && { name: "shared.json", text: link.text, seenThrough: link.camera };
}

/** The scene that this tab has shown last. */
function last() {
  try {
    const [name, text] = JSON.parse(kept("scene"));
    if (typeof text === "string") return { name: String(name), text };
    $("notice").textContent = `The browser could not keep ${name}: open it again. Another scene is shown.`;
  } catch { /* there is none, or what there is was not kept by this page */ }
  return null;
}

/** The page's own scene. */
async function first() {
  if (location.hash.startsWith("#pixel=")) $("notice").textContent = "This address holds a pixel but no scene: this is the page's first one.";
  const answer = await fetch("room.json").catch(() => null);
  const isRoom = answer?.ok && isFile("room.json", answer);
  if (!isRoom) $("notice").textContent = "This page is not complete: its host does not have room.json.";
  return { name: "room.json", text: isRoom ? await answer.text() : "" };
}

/** Sends one or several requests. */
export function send(requests) {
  if (requests.diagnose === false) cancel();
  isSearching ||= Boolean(requests.diagnose);
  if (requests.diagnose && !workers.search) {
    start("search");
    begin("search");
  }
  if (requests.forgetMine) mine = null;
  tell("Ask", JSON.stringify(requests));
}

/** Takes a scene: the name of its file, and its text. It is there again after the page was loaded again, but for a very long one. */
export function change(...next) {
  scene = next;
  if (scene[1].length > 1_000_000 || !keep("scene", JSON.stringify(scene))) keep("scene", JSON.stringify([scene[0], null]));
  cancel();
  tell("Change", ...scene);
}

/** Takes a picture of the user's own program. Returns why it was refused; null if it was not. */
export async function sendPicture(file) {
  if (file.size > 50_000_000) return "it is larger than any picture that this page shows";
  mine = [file.name, new Uint8Array(await file.arrayBuffer())];
  cancel();
  tell("Compare", ...mine);
  return null;
}

/** Ends a diagnosis. */
function cancel() {
  end("search");
  if (isSearching) told.message(JSON.stringify({ kind: "diagnosis", text: "The diagnosis was cancelled." }));
  isSearching = false;
}

function tell(...call) {
  for (const worker of Object.values(workers)) worker.postMessage(call);
}

function start(name) {
  let worker;
  try {
    worker = workers[name] = new Worker("worker.js", { type: "module" });
  } catch (refusal) {
    return fail(refusal.message);
  }
  worker.addEventListener("message", event => {
    if (!isOpen) told.open();
    isOpen = true;
    if (typeof event.data !== "string") begin("study");
    if (name === "search") isSearching = false;
    told.message(event.data);
  });
  worker.addEventListener("error", event => { if (workers[name] === worker) fail(event.message); });
  waiting.add(name);
  worker.postMessage(["Start", answers[name], ...scene]);
  if (mine) worker.postMessage(["Compare", ...mine]);
}

function begin(name) {
  if (waiting.delete(name)) workers[name].postMessage(["Begin"]);
}

function end(name) {
  workers[name]?.terminate();
  waiting.delete(name);
  delete workers[name];
}

/** Begins anew after a fault of a worker, as when its memory is full. One that has never answered would fail again. */
async function fail(reason) {
  const hasBegun = isOpen;
  Object.keys(workers).forEach(end);
  isOpen = isSearching = false;
  if (hasBegun) return told.closed(`RayCaster has ended in this page (${reason}); it starts again.`);
  if (isOver) return;
  isOver = true;
  const why = reason?.replace(/^Uncaught (\w*Error: )?/, "") ?? "it allows no worker";
  told.closed(await lacks() ?? `RayCaster cannot start in this browser: ${why}.`, true);
}
