// The connection to the server: sends requests, receives messages and frames, and connects again after a break.

const delay = { first: 200, longest: 3000 }; // milliseconds between attempts
const listeners = {};
// The program's address has the token after "#". It stays in this tab: no other page and no other port gets it.
const given = /#token=(\w+)/.exec(location.hash);
if (given) {
  sessionStorage.setItem("token", given[1]);
  history.replaceState(null, "", location.pathname);
}
export const token = sessionStorage.getItem("token") ?? "none";
let socket = null;
let wait = delay.first;
let everOpen = false;
const memory = {}; // the newest request of each kind that the server must know after a break
const remembered = new Set(["camera", "explain", "map", "hint"]);

/** Registers a function for each message of a kind. "frame", "open" and "closed" are kinds, too. */
export function on(kind, listener) {
  (listeners[kind] ??= []).push(listener);
}

/** Sends one or several requests; the server takes them in order. */
export function ask(requests) {
  for (const [name, value] of Object.entries(requests)) if (remembered.has(name)) memory[name] = value;
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(requests));
}

/** Notes a request that the server must know after a break. */
export function remember(name, value) {
  memory[name] = value;
}

export function connect() {
  socket = new WebSocket(`ws://${location.host}/live`, token);
  socket.binaryType = "arraybuffer";
  socket.addEventListener("open", () => {
    wait = delay.first;
    if (everOpen) for (const [name, value] of Object.entries(memory)) if (value !== null) ask({ [name]: value });
    everOpen = true;
    tell("open");
  });
  socket.addEventListener("message", event => {
    if (typeof event.data !== "string") return tell("frame", asFrame(event.data));
    const message = JSON.parse(event.data);
    tell(message.kind, message);
  });
  socket.addEventListener("close", () => {
    tell("closed");
    setTimeout(connect, wait);
    wait = Math.min(2 * wait, delay.longest);
  });
}

function tell(kind, message) {
  for (const listener of listeners[kind] ?? []) listener(message);
}

/** Six numbers, then the pixels in the format of a canvas: nothing is copied. */
function asFrame(buffer) {
  const [layer, version, number, isFinal, width, height] = new Int32Array(buffer, 0, 6);
  return { layer, version, number, isFinal: isFinal === 1, image: new ImageData(new Uint8ClampedArray(buffer, 24), width, height), width, height };
}
