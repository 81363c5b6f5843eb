// Drag, wheel, keys and touch. The page sends how far the hand has moved; the server computes the camera.
import { firstDivisor } from "./connection.js";
import { $ } from "./dom.js";
import { pixelAt, size } from "./picture.js";
import { ask } from "./server.js";

const restAfter = 100;        // milliseconds without a move
const longest = 250;          // milliseconds to wait for a frame at most
const click = 4;              // pixels that the pointer may move during a click
const turnOfPicture = 2.5;    // radians for a drag over the picture's height
const stepOfKey = 0.06;       // of the picture's height
const stage = $("stage");
const pointers = new Map();   // the last place of each pointer that is down
let travelled = 0, wasMany = false;
let pending = null;           // moves that are not sent yet
let timer = 0;
let asked = 0;                // the time of the request whose frame has not come yet; 0 for none
let divisor = firstDivisor, took = 16;   // of the frames' size while the camera moves, and the mean time of one in milliseconds

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
  const now = { x: event.clientX, y: event.clientY };
  const [dx, dy] = [(now.x - before.x) / height, (now.y - before.y) / height];
  travelled += Math.abs(now.x - before.x) + Math.abs(now.y - before.y);
  pointers.set(event.pointerId, now);
  if (pointers.size === 2) { // spreading two fingers moves the camera nearer, moving both pans
    const other = [...pointers].find(([id]) => id !== event.pointerId)[1];
    const distance = p => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
    move({ approach: distance(before) / distance(now), shift: [-dx / 2, dy / 2] });
  } else if (travelled > click) {
    if (event.buttons & 2 || event.shiftKey) move({ shift: [-dx, dy] });
    else move({ turn: [-dx * turnOfPicture, dy * turnOfPicture] });
  }
});

for (const name of ["pointerup", "pointercancel"])
  stage.addEventListener(name, event => {
    if (!pointers.delete(event.pointerId) || pointers.size > 0) return;
    if (travelled > click) return rest();
    const pixel = pixelAt(event.clientX, event.clientY);
    if (pixel && name === "pointerup" && !wasMany && event.button === 0) hand.onClick(pixel);
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
  const scaled = factor => arrow.map(value => value * stepOfKey * factor);
  if (arrow && event.shiftKey) move({ shift: scaled(1) });
  else if (arrow && hand.onStep(arrow)) { /* the explained pixel has moved, not the camera */ }
  else if (arrow) move({ turn: scaled(turnOfPicture / 2) });
  else if (event.key === "+" || event.key === "=") move({ approach: 1 / 1.1 });
  else if (event.key === "-" || event.key === "−") move({ approach: 1.1 });
  else if (event.key === "Enter") hand.onClick([size.width >> 1, size.height >> 1]);
  else if (event.key === "Escape") hand.onClick(null);
  else return;
  event.preventDefault();
});

/** Adds to the pending moves, which are sent after the next frame. */
function move({ turn = [0, 0], shift = [0, 0], approach = 1 }) {
  if (!pending) requestAnimationFrame(send);
  pending ??= { turn: [0, 0], shift: [0, 0], approach: 1 };
  const sum = (a, b) => a.map((value, i) => value + b[i]);
  pending = { turn: sum(pending.turn, turn), shift: sum(pending.shift, shift), approach: pending.approach * approach };
  clearTimeout(timer);
  timer = setTimeout(rest, restAfter);
}

function send(isLast = false) {
  if (!pending) return;
  const now = performance.now();
  if (isLast !== true && asked > 0 && now - asked < longest) return void requestAnimationFrame(send);
  ask({ divisor, ...pending });
  [asked, pending] = [now, null];
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
  const other = took > 100 ? Math.min(8, divisor + 1) : took > 26 && divisor < 4 ? divisor + 1 : took < 9 ? Math.max(1, divisor - 1) : divisor;
  if (other !== divisor) [divisor, took] = [other, 16];
});
