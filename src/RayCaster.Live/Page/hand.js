// Drag, wheel, keys and touch. The page sends how far the hand has moved; the server computes the camera.
import { $ } from "./dom.js";
import { pixelAt, size } from "./picture.js";
import { ask } from "./server.js";

const restAfter = 100;        // milliseconds without a move
const click = 4;              // pixels that the pointer may move during a click
const turnOfPicture = 2.5;    // radians for a drag over the picture's height
const stepOfKey = 0.06;       // of the picture's height
const stage = $("stage");
const pointers = new Map();   // the last place of each pointer that is down
let travelled = 0, wasMany = false;
let pending = null;           // moves that are not sent yet: the turn, the shift, and the logarithm of the approach
let timer = 0;
let asked = 0;                // the time of the request whose frame has not come yet; 0 for none
let divisor = 1, took = 16, taken = 0;
const glide = 0.5;            // the part of the pending moves that is sent with the next frame
const longest = 250;          // milliseconds to wait for a frame at most
const still = matchMedia("(prefers-reduced-motion: reduce)");

/** What to do when somebody points, clicks, or presses an arrow key. */
export const hand = { onPoint: () => {}, onClick: () => {}, onStep: () => false };

stage.addEventListener("pointerdown", event => {
  if (event.button > 2) return;
  stage.setPointerCapture(event.pointerId);
  if (pointers.size === 0) [travelled, wasMany] = [0, false];
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  wasMany ||= pointers.size > 1;
});

stage.addEventListener("pointermove", event => {
  const before = pointers.get(event.pointerId);
  if (!before) return hand.onPoint(pixelAt(event.clientX, event.clientY));
  const height = stage.getBoundingClientRect().height;
  const [dx, dy] = [(event.clientX - before.x) / height, (event.clientY - before.y) / height];
  travelled += Math.abs(event.clientX - before.x) + Math.abs(event.clientY - before.y);
  if (pointers.size === 2) pinch(event, before, height);
  else if (travelled > click) {
    if (event.buttons & 2 || event.shiftKey) move({ shift: [-dx, dy] });
    else move({ turn: [-dx * turnOfPicture, dy * turnOfPicture] });
  }
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
});

/** Two fingers: spreading them moves the camera nearer, moving both pans. */
function pinch(event, before, height) {
  const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
  const distance = p => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
  const now = { x: event.clientX, y: event.clientY };
  move({ approach: distance(before) / distance(now), shift: [-(now.x - before.x) / height / 2, (now.y - before.y) / height / 2] });
}

for (const name of ["pointerup", "pointercancel"])
  stage.addEventListener(name, event => {
    if (!pointers.delete(event.pointerId) || pointers.size > 0) return;
    if (name === "pointerup" && travelled <= click && !wasMany && event.button === 0) {
      const pixel = pixelAt(event.clientX, event.clientY);
      if (pixel) hand.onClick(pixel);
    } else if (travelled > click) rest();
  });

stage.addEventListener("contextmenu", event => event.preventDefault());
stage.addEventListener("wheel", event => {
  event.preventDefault();
  const lines = event.deltaMode === 0 ? event.deltaY / 100 : event.deltaY / 3;
  move({ approach: Math.exp(Math.max(-1, Math.min(1, lines)) * 0.15) });
}, { passive: false });

stage.addEventListener("keydown", event => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
  if (arrow && event.shiftKey) move({ shift: [arrow[0] * stepOfKey, arrow[1] * stepOfKey] });
  else if (arrow && hand.onStep(arrow)) { /* the explained pixel has moved, not the camera */ }
  else if (arrow) move({ turn: [arrow[0] * stepOfKey * turnOfPicture / 2, arrow[1] * stepOfKey * turnOfPicture / 2] });
  else if (event.key === "+" || event.key === "=") move({ approach: 1 / 1.1 });
  else if (event.key === "-" || event.key === "−") move({ approach: 1.1 });
  else if (event.key === "Enter") hand.onClick([size.width >> 1, size.height >> 1]);
  else if (event.key === "Escape") hand.onClick(null);
  else return;
  event.preventDefault();
});

/** Adds to the pending moves. */
function move({ turn = [0, 0], shift = [0, 0], approach = 1 }) {
  if (!pending) requestAnimationFrame(send);
  pending = [...turn, ...shift, Math.log(approach)].map((value, i) => value + (pending?.[i] ?? 0));
  clearTimeout(timer);
  timer = setTimeout(rest, restAfter);
}

/**
 * Sends a part of the pending moves after each frame, so that the camera glides from one event of the mouse to the next. With reduced motion, and at
 * the end, it sends them all.
 */
function send(isLast = false) {
  if (!pending) return;
  const now = performance.now();
  if (isLast !== true && asked > 0 && now - asked < longest) return void requestAnimationFrame(send);
  const part = isLast === true || Math.max(...pending.map(Math.abs)) < 0.004 || still.matches ? 1 : glide;
  const [right, up, across, along, approach] = pending.map(value => value * part);
  const requests = { divisor };
  if (right || up) requests.turn = [right, up];
  if (across || along) requests.shift = [across, along];
  if (approach) requests.approach = Math.exp(approach);
  asked = now;
  ask(requests);
  pending = part === 1 ? null : pending.map(value => value * (1 - part));
  if (pending) requestAnimationFrame(send);
}

function rest() {
  clearTimeout(timer);
  send(true);
  ask({ rest: true });
}

/** Chooses the size of the frames while the camera moves: as large as thirty frames a second allow. */
stage.addEventListener("frame", event => {
  if (event.detail.isFinal || asked === 0) return;
  took += (performance.now() - asked - took) / 4; // a mean of the last frames in which the newest weighs most
  asked = 0;
  if (++taken < 4) return;
  if (took > 26 && divisor < 4) [divisor, taken] = [divisor + 1, 0];
  else if (took < 9 && divisor > 1) [divisor, taken] = [divisor - 1, -12];
});
