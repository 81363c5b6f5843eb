// What the page and the program say to each other: requests, messages and frames; connects again after a break.
import { connect as open, send } from "./connection.js";

const delay = { first: 200, longest: 3000 }; // milliseconds between attempts
const listeners = {};
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
  send(requests);
}

/** Notes a request that the server must know after a break. */
export function remember(name, value) {
  memory[name] = value;
}

export function connect() {
  open({
    open() {
      wait = delay.first;
      if (everOpen) for (const [name, value] of Object.entries(memory)) if (value !== null) ask({ [name]: value });
      everOpen = true;
      tell("open");
    },
    message(data) {
      if (typeof data !== "string") return tell("frame", asFrame(data));
      const message = JSON.parse(data);
      tell(message.kind, message);
    },
    camera(camera) {
      ask({ camera });
    },
    closed(reason, forEver = false) {
      tell("closed", reason);
      if (forEver) return;
      setTimeout(connect, wait);
      wait = Math.min(2 * wait, delay.longest);
    },
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
