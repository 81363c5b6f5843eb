// The list of models: hide one, light it alone, or show it behind others; and the ledger of the rays.
import { $, make, show, swatch } from "./dom.js";
import { ask, on } from "./server.js";

let scene = null;
const hidden = new Set();
let looked = ["plain", -1];

on("scene", message => {
  const isOther = !scene || message.models?.map(model => model.name).join() !== scene.models?.map(model => model.name).join();
  scene = message;
  if (!scene.models) return;
  if (isOther) build();
  if ($("map-kind").value !== "model") paintSwatches(scene.models.map(model => model.color));
});

on("ledger", ledger => {
  ledger.models.forEach((entry, i) => {
    const cell = $(`model-${i}-rays`);
    if (!cell) return;
    const share = entry.shows / Math.max(1, ledger.rays) * 100;
    cell.textContent = hidden.has(i) ? "hidden" : entry.shows > 0 ? `${share < 0.1 ? "<\u00a00.1" : share.toFixed(1)}\u00a0%` : entry.reason;
    $(`model-${i}`).classList.toggle("unseen", entry.shows === 0);
  });
  $("ledger-report").textContent = hidden.size > 0 && hidden.size === scene.modelCount ? "All models are hidden." : ledger.report;
});

on("legend", legend => {
  if (legend.map === "model") paintSwatches(legend.colors);
});

$("map-kind").addEventListener("change", event => {
  if (event.target.value !== "model") paintSwatches(scene?.models?.map(model => model.color));
});

function paintSwatches(colors = []) {
  colors.forEach((color, i) => { if ($(`model-${i}`)) $(`model-${i}`).querySelector(".swatch").style.background = color; });
}

function build() {
  hidden.clear();
  if (looked[1] >= 0) look("plain", -1);
  ask({ hidden: [] });
  const rows = scene.models.map((model, i) => make("tr", { id: `model-${i}` },
    make("th", { scope: "row" }, swatch(model.color), ` ${model.name}`, make("span", { class: "type" }, ` ${model.type}`)),
    make("td", { id: `model-${i}-rays` }, "…"),
    make("td", {}, make("div", { class: "buttons" },
      toggle(i, "hide", "hide", `Hide ${model.name}`, button => hide(i, button)),
      toggle(i, "lit", "alone", `Light ${model.name} alone`, () => look("lit", i)),
      toggle(i, "behind", "behind", `Show ${model.name} where it is behind others`, () => look("behind", i))))));
  const more = scene.modelCount - scene.models.length;
  $("model-list").replaceChildren(rows.length === 0 ? make("p", {}, "The scene holds no models.") : make("table", {},
    make("thead", {}, make("tr", {}, ...["model", "shows in", "view"].map(title => make("th", { scope: "col" }, title)))),
    make("tbody", {}, ...rows)),
  more > 0 ? make("p", {}, `and ${more} more`) : "");
}

function toggle(i, name, text, label, press) {
  const onclick = event => press(event.currentTarget);
  return make("button", { type: "button", id: `model-${i}-${name}`, "aria-pressed": "false", "aria-label": label, title: label, onclick }, text);
}

function hide(i, button) {
  if (!hidden.delete(i)) hidden.add(i);
  button.setAttribute("aria-pressed", hidden.has(i));
  $(`model-${i}-rays`).textContent = hidden.has(i) ? "hidden" : "…";
  ask({ hidden: [...hidden].sort((a, b) => a - b) });
}

/** Shows one model alone or behind others; the same button pressed again ends that. */
function look(how, i) {
  const isSame = looked[0] === how && looked[1] === i;
  looked = isSame ? ["plain", -1] : [how, i];
  document.querySelectorAll("#model-list button[id$=-lit], #model-list button[id$=-behind]").forEach(button =>
    button.setAttribute("aria-pressed", button.id === `model-${looked[1]}-${looked[0]}`));
  ask({ look: looked });
}
