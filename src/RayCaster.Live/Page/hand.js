// Drag, wheel, keys and touch. Only by how much the hand has moved is said; where the camera then is, the server computes.
import { $ } from "./dom.js";
import { frames, pixelAt, size } from "./picture.js";
import { ask } from "./server.js";

const restAfter = 100;        // milliseconds without a move
const click = 4;              // pixels that a click may wander
const turnOfPicture = 2.5;    // radians for a drag over the picture's height
const stepOfKey = 0.06;       // of the picture's height
const stage = $("stage");
const pointers = new Map();   // those that are down: where they were last
let travelled = 0, wasMany = false;
let pending = null;           // moves that wait for the next frame of the screen
let timer = 0;
let divisor = 1, judged = 0;

/** Calls back where somebody clicks, points, or presses a key that steps. */
export const hand = { onPoint: () => {}, onClick: () => {}, onStep: () => false, onLeave: () => {} };

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

/** Two fingers: apart is nearer, side by side pans. */
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

stage.addEventListener("pointerleave", () => hand.onLeave());
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
  else if (arrow && hand.onStep(arrow)) { /* the pixel has moved, not the camera */ }
  else if (arrow) move({ turn: [arrow[0] * stepOfKey * turnOfPicture / 2, arrow[1] * stepOfKey * turnOfPicture / 2] });
  else if (event.key === "+" || event.key === "=") move({ approach: 1 / 1.1 });
  else if (event.key === "-" || event.key === "−") move({ approach: 1.1 });
  else if (event.key === "Enter") hand.onClick([size.width >> 1, size.height >> 1]);
  else if (event.key === "Escape") hand.onClick(null);
  else return;
  event.preventDefault();
});

/** Adds a move to those that go out with the next frame of the screen. */
function move(wish) {
  if (!pending) {
    pending = { turn: [0, 0], shift: [0, 0], approach: 1 };
    requestAnimationFrame(send);
  }
  for (const name of ["turn", "shift"])
    if (wish[name]) pending[name] = pending[name].map((value, i) => value + wish[name][i]);
  pending.approach *= wish.approach ?? 1;
  clearTimeout(timer);
  timer = setTimeout(rest, restAfter);
}

function send() {
  if (!pending) return;
  const { turn, shift, approach } = pending;
  pending = null;
  judge();
  const wishes = { divisor };
  if (turn.some(Boolean)) wishes.turn = turn;
  if (shift.some(Boolean)) wishes.shift = shift;
  if (approach !== 1) wishes.approach = approach;
  ask(wishes);
}

function rest() {
  clearTimeout(timer);
  send();
  ask({ rest: true });
}

/** Chooses how small the frames are: so that thirty come in a second, and sharp where the machine is fast enough. */
function judge() {
  const now = performance.now();
  if (now - judged < 250) return;
  const recent = frames.times.filter(time => time > now - 500);
  judged = now;
  if (recent.length < 3) return void (divisor = Math.max(divisor, size.width * size.height > 1e6 ? 2 : divisor));
  const rate = (recent.length - 1) / (recent.at(-1) - recent[0]) * 1000;
  if (rate < 32) divisor = Math.min(4, divisor + 1);
  else if (rate > 55 && divisor > 1) divisor--;
}
