// The connection to RayCaster in Web Workers. A worker does one thing at a time, so there are three: the camera turns at once while another one
// counts rays, and a diagnosis that takes too long ends with its worker.

const answers = {
  view: "Scene, Hover, Frame, Camera, Explanation",
  study: "Map, Comparison, Ledger",
  search: "Diagnosis",
};
const workers = {};
let isOpen = false; // whether a worker has said something
let told = null;   // what to do with what the workers send
let scene = null;  // its name and its text
let mine = null;   // the user's picture: its name and its bytes

/** By how much the first frame's sides are divided while the camera moves. */
export const firstDivisor = 4;

export async function connect(listener) {
  told = listener;
  document.body.classList.add("alone");
  scene ??= ["room.json", await (await fetch("room.json")).text()];
  start("view");
  start("study");
}

/** Sends one or several requests. */
export function send(requests) {
  if (requests.diagnose === false && workers.search) {
    end("search");
    told.message(JSON.stringify({ kind: "diagnosis", text: "The diagnosis was cancelled." }));
  }
  if (requests.diagnose && !workers.search) start("search");
  if (requests.forgetMine) mine = null;
  tell("Ask", JSON.stringify(requests));
}

/** Takes the scene's new text. */
export function change(text) {
  scene[1] = text;
  end("search");
  tell("Change", text);
}

/** Takes a picture of the user's own program. */
export async function sendPicture(file) {
  mine = [file.name, new Uint8Array(await file.arrayBuffer())];
  end("search");
  tell("Compare", ...mine);
}

function tell(...call) {
  for (const worker of Object.values(workers)) worker.postMessage(call);
}

function start(name) {
  const worker = workers[name] = new Worker("worker.js", { type: "module" });
  worker.addEventListener("message", event => {
    if (!isOpen) told.open();
    isOpen = true;
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
  isOpen = false;
  told.closed(`RayCaster has ended in this page (${reason}); it starts again.`);
}
