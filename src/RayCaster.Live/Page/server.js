// The line to the server: wishes go out, messages and frames come in. A line that breaks is taken up again.

const patience = { first: 200, most: 3000 }; // milliseconds between attempts
const listeners = new Map();
let socket = null;
let wait = patience.first;
let everOpen = false;
const memory = {}; // what the server must know after a break: the newest wish of each of these kinds
const remembered = new Set(["camera", "hidden", "look", "explain", "map", "hint"]);

/** Calls back for each message of a kind; "frame", "open" and "closed" are kinds, too. */
export function on(kind, listener) {
  if (!listeners.has(kind)) listeners.set(kind, []);
  listeners.get(kind).push(listener);
}

/** Says what the page wants; several wishes at once are taken in order. */
export function ask(wishes) {
  for (const [name, value] of Object.entries(wishes)) if (remembered.has(name)) memory[name] = value;
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(wishes));
}

/** Lets the page say after a break which camera it has. */
export function remember(name, value) {
  memory[name] = value;
}

export function connect() {
  socket = new WebSocket(`ws://${location.host}/live`);
  socket.binaryType = "arraybuffer";
  socket.addEventListener("open", () => {
    wait = patience.first;
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
    wait = Math.min(2 * wait, patience.most);
  });
}

function tell(kind, message) {
  for (const listener of listeners.get(kind) ?? []) listener(message);
}

/** Six numbers, then the pixels as a canvas takes them: nothing is copied. */
function asFrame(buffer) {
  const [layer, version, number, isFinal, width, height] = new Int32Array(buffer, 0, 6);
  return { layer, version, number, isFinal: isFinal === 1, image: new ImageData(new Uint8ClampedArray(buffer, 24), width, height), width, height };
}
