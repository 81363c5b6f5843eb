// Shows how one pixel got its colour, in the text of "explain".
import { $, lines, make, reveal, show, swatch } from "./dom.js";
import { mark, size } from "./picture.js";
import { section } from "./section.js";
import { readdress } from "./memory.js";
import { ask, on } from "./server.js";

let chosen = null, isNew = false; // isNew: its explanation has not come
const opened = new Map(); // the parts that somebody has opened or closed

/** Explains a pixel; null ends that. */
export function explain(pixel) {
  [chosen, isNew] = [pixel, pixel !== null];
  ask(pixel ? { explain: pixel, hover: pixel } : { explain: null });
  $("hover").setAttribute("aria-live", "polite");
  mark(pixel);
  $(pixel ? "arrows-step" : "arrows-turn").checked = true;
  show($("pixel-explained"), pixel !== null);
  show($("pixel-none"), pixel === null);
  const address = pixel ? `#pixel=${pixel}` : location.pathname;
  if (location.hash !== address) readdress(address);
}

/** Goes to the pixel beside the explained one; false if none is explained. */
export function step(right, down) {
  if (!chosen) return false;
  const to = [Math.min(size.width - 1, Math.max(0, chosen[0] + right)), Math.min(size.height - 1, Math.max(0, chosen[1] + down))];
  explain(to);
  return true;
}

/** Explains the nearest pixel if the picture has become too small for the explained one. */
export function stayInside() {
  if (chosen && (chosen[0] >= size.width || chosen[1] >= size.height)) step(0, 0);
}

on("explanation", ({ column, line, color, gist, sections, drawing }) => {
  if (!chosen || column !== chosen[0] || line !== chosen[1]) return; // it explains a pixel that was chosen before
  mark(chosen);
  const [head, ...parts] = sections;
  $("pixel-head").replaceChildren(swatch(color), ` ${head.text}`);
  $("pixel-gist").replaceChildren(...lines(gist));
  $("pixel-parts").replaceChildren(section(drawing), ...parts.map(part));
  if (isNew) reveal($("pixel"));
  isNew = false;
});

/** A part that can be opened and closed, and keeps that state for the next pixel. */
function part({ title, text }) {
  const key = title.split(":")[0];
  const details = make("details", { open: opened.get(key) ?? key === "Your picture" }, make("summary", {}, title),
    make("pre", { tabindex: 0, role: "group", "aria-label": key }, ...lines(text)));
  details.addEventListener("toggle", () => opened.set(key, details.open));
  return details;
}
