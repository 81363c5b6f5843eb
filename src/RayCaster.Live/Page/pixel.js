// Shows how one pixel got its colour: the words and numbers of "explain". The page computes nothing.
import { $, digits, make, show, swatch } from "./dom.js";
import { mark, size } from "./picture.js";
import { section } from "./section.js";
import { ask, on } from "./server.js";

const verdicts = { shows: "shows", hidden: "is hidden", notNeeded: "is not needed", refused: "does not count", missed: "is missed" };
let chosen = null;
const opened = new Map(); // the parts that somebody has opened or closed

/** Explains a pixel; null ends that. */
export function explain(pixel) {
  chosen = pixel;
  ask(pixel ? { explain: pixel, hover: pixel } : { explain: null });
  $("hover").setAttribute("aria-live", "polite");
  mark(pixel);
  $(pixel ? "arrows-step" : "arrows-turn").checked = true;
  show($("pixel-explained"), pixel !== null);
  show($("pixel-none"), pixel === null);
  const address = pixel ? `#pixel=${pixel}` : location.pathname;
  if (location.hash !== address) history.replaceState(null, "", address);
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

on("explanation", message => {
  const pixel = message.pixel;
  if (!chosen || pixel.pixel.column !== chosen[0] || pixel.pixel.line !== chosen[1]) return; // it explains a pixel that was chosen before
  mark(chosen);
  const box = $("pixel-explained");
  box.replaceChildren(...[head(pixel), ...notes(pixel), section(message.section, pixel),
    part("camera", "Camera, the same for every pixel", pixel.camera.slide, steps(pixel.camera.steps)),
    part("ray", "Ray through this pixel", pixel.ray.slide, steps(pixel.ray.steps), counts(pixel), true),
    ...pixel.models.filter(model => !(model.mesh && model.mesh.triangles === 0)).map(model => modelPart(model)),
    others(pixel.others), part("colour", "Colour", pixel.color.slide, steps(pixel.color.steps), null, true),
    reference(pixel.reference)].filter(Boolean));
});

function head({ pixel, hit, color }) {
  const hex = `#${color.bytes.map(byte => byte.toString(16).padStart(2, "0")).join("")}`;
  return make("p", { id: "pixel-head" }, swatch(hex), ` column ${pixel.column}, line ${pixel.line} from the top (row r = ${pixel.row}): `,
    make("strong", { id: "pixel-model" }, hit?.name ?? "the background"), hit ? ` at t = ${digits(hit.t)}` : "", ", bytes ",
    make("strong", { id: "pixel-bytes" }, color.bytes.join(" ")), ". ",
    make("a", { href: `#pixel=${pixel.column},${pixel.line}` }, "Link to this pixel"));
}

function notes(pixel) {
  return pixel.notes.map(note => make("p", { class: "note" }, `Note: ${note}.`));
}

/** A part that can be opened and closed, and keeps that state for the next pixel. */
function part(key, title, slide, content, more = null, open = false) {
  const details = make("details", { open: opened.get(key) ?? open },
    make("summary", {}, title, slide ? make("span", { class: "slide" }, ` slide “${slide}”`) : ""), content, more);
  details.addEventListener("toggle", () => opened.set(key, details.open));
  return details;
}

function modelPart(model) {
  const content = make("div", {}, model.beside ? make("p", {}, `It shows in the next pixel: ${model.beside}.`) : null,
    model.mesh ? make("p", {}, mesh(model.mesh)) : null, slabs(model.slabs), steps(model.steps), crossings(model));
  const details = part(`model ${model.index}`, "", model.slide, content, null, model.verdict === "shows");
  details.classList.add(model.verdict);
  details.querySelector("summary").prepend(make("strong", {}, model.name), ` (${model.type}): ${model.reason}.`);
  return details;
}

/** Named steps: the formula, the formula with this pixel's numbers, the value. */
function steps(list) {
  if (list.length === 0) return make("p", {}, "Its formula has no named steps.");
  return make("table", {}, make("tbody", {}, ...list.map(step => {
    const value = typeof step.value === "boolean" ? `is ${step.value}` : `= ${digits(step.value)}`;
    const plain = typeof step.value === "boolean" ? "" : digits(step.value);
    const numbers = step.numbers === step.formula || step.numbers === plain ? null : make("div", { class: "numbers" }, `= ${step.numbers}`);
    return make("tr", {}, make("th", { scope: "row" }, step.name), make("td", {},
      make("div", { class: "formula" }, `= ${step.formula}`), numbers, make("div", { class: "value" }, value)));
  })));
}

function slabs(list) {
  if (!list) return null;
  const cells = { lo: "B0", hi: "B1", t0: "t0", t1: "t1", enters: "enters", leaves: "leaves" };
  return make("div", { class: "scroll", tabindex: 0, role: "group", "aria-label": "Slabs" }, make("table", {},
    make("thead", {}, make("tr", {}, ...["slab", ...Object.values(cells), ""].map(cell => make("th", { scope: "col" }, cell)))),
    make("tbody", {}, ...list.map(slab => make("tr", {}, make("th", { scope: "row" }, slab.axis),
      ...Object.keys(cells).map(cell => make("td", {}, digits(slab[cell]))),
      make("td", {}, [slab.decidesEntry ? "t_min" : null, slab.decidesExit ? "t_max" : null].filter(Boolean).join(", ")))))));
}

function crossings(model) {
  return make("ul", {}, ...model.crossings.map(({ t, z, numbers, untested, verdict, reason }) => t === "NaN"
    ? make("li", {}, `no crossing${untested === undefined ? "" : `; the test fails at t = ${digits(untested)}`}`)
    : make("li", { class: verdict }, `t = ${numbers ? `${numbers} = ` : ""}${digits(t)}, z = ${digits(z)}: ${reason || verdicts[verdict]}`)));
}

function mesh({ triangles, triangle, missed, behind, underBias, beforeNear, beyondFar, counting }) {
  const fates = [[missed, "missed"], [behind, "behind the camera"], [underBias, "under the bias"], [beforeNear, "nearer than zNear"],
    [beyondFar, "beyond zFar"], [counting, "hit"]];
  const which = triangle === null ? "." : `; number ${triangle}, from 0, is explained:`;
  return `${triangles} triangles tried: ${fates.filter(([number]) => number > 0).map(([number, fate]) => `${number} ${fate}`).join(", ")}${which}`;
}

function counts({ camera, ray }) {
  const least = camera.bias === 0 ? "t ≥ 0" : `t > bias = ${digits(camera.bias)}`;
  const z = camera.clip === "depth" ? `z = t · (−d·W) = t · ${digits(ray.depthPerT)}` : "z = t";
  return make("p", {}, `${z}. A crossing counts where ${least} and zNear = ${digits(camera.zNear)} ≤ z ≤ zFar = ${digits(camera.zFar)}.`);
}

function others(other) {
  return other.count === 0 ? null : make("p", {}, `${other.count} other models: ${other.missed} missed, ${other.hidden} hidden, ` +
    `${other.behind} behind the camera, ${other.underBias} under the bias, ${other.beforeNear} nearer than zNear, ${other.beyondFar} beyond zFar.`);
}

function reference(other) {
  if (!other) return null;
  const verdict = other.difference.every(level => level === 0) ? "the same" : other.agrees ? "the same but for rounding" : "different";
  return make("div", { id: "pixel-mine" }, make("h3", {}, "In your picture"), make("p", {}, `bytes ${other.bytes.join(" ")}: ${verdict}.`),
    ...other.causes.map(cause => make("p", {}, `Perhaps: ${cause}.`)));
}
