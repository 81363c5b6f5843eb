// The connection to RayCaster in Web Workers. A worker does one thing at a time, so there are three: the camera turns at once while another one
// counts rays, and a diagnosis that takes too long ends with its worker.
import { fromLink } from "./link.js";

const answers = { view: "Scene, Hover, Frame, Camera, Explanation", study: "Map, Comparison, Ledger", search: "Diagnosis" };
const workers = {};
let isOpen = false; // whether a worker has said something
let isSearching = false; // whether a diagnosis runs
let told = null;   // what to do with what the workers send
let mine = null;   // the user's picture: its name and its bytes

/** The name of the scene's file, and its text. */
export let scene = null;

/** By how much the first frame's sides are divided while the camera moves. */
export const firstDivisor = 4;

export async function connect(listener) {
  told = listener;
  document.body.classList.add("alone");
  if (!scene) change(...await fromLink() ?? JSON.parse(sessionStorage.getItem("scene")) ?? ["room.json", await (await fetch("room.json")).text()]);
  ["view", "study"].forEach(start);
}

/** Sends one or several requests. */
export function send(requests) {
  if (requests.diagnose === false) cancel();
  isSearching ||= Boolean(requests.diagnose);
  if (requests.diagnose && !workers.search) start("search");
  if (requests.forgetMine) mine = null;
  tell("Ask", JSON.stringify(requests));
}

/** Takes a scene: the name of its file, and its text. It is there again after the page was loaded again, but for a very long one. */
export function change(...next) {
  scene = next;
  sessionStorage.setItem("scene", JSON.stringify(scene[1].length < 1_000_000 ? scene : null));
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
  const worker = workers[name] = new Worker("worker.js", { type: "module" });
  worker.addEventListener("message", event => {
    if (!isOpen) told.open();
    isOpen = true;
    if (name === "search") isSearching = false;
    told.message(event.data);
  });
  worker.addEventListener("error", event => { if (workers[name] === worker) fail(event.message); });
  worker.postMessage(["Start", answers[name], ...scene]);
  if (mine) worker.postMessage(["Compare", ...mine]);
}

function end(name) {
  workers[name]?.terminate();
  delete workers[name];
}

/** Begins anew after a fault of a worker, as when its memory is full. */
function fail(reason) {
  Object.keys(workers).forEach(end);
  isOpen = isSearching = false;
  told.closed(`RayCaster has ended in this page (${reason}); it starts again.`);
}
