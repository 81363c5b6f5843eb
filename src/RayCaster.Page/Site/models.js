// The list of models, and the ledger of the rays.
import { $, make, swatch } from "./dom.js";
import { on } from "./server.js";

let scene = null;

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
    cell.textContent = entry.shows > 0 ? `${share < 0.1 ? "<\u00a00.1" : share.toFixed(1)}\u00a0%` : entry.reason;
    $(`model-${i}`).classList.toggle("unseen", entry.shows === 0);
  });
  $("ledger-report").textContent = ledger.report;
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
  const rows = scene.models.map((model, i) => make("tr", { id: `model-${i}` },
    make("th", { scope: "row" }, swatch(model.color), ` ${model.name}`, make("span", { class: "type" }, ` ${model.type}`)),
    make("td", { id: `model-${i}-rays` }, "…")));
  const more = scene.modelCount - scene.models.length;
  $("model-list").replaceChildren(rows.length === 0 ? make("p", {}, "The scene holds no models.") : make("table", {},
    make("thead", {}, make("tr", {}, ...["model", "shows in"].map(title => make("th", { scope: "col" }, title)))),
    make("tbody", {}, ...rows)),
  more > 0 ? make("p", {}, `and ${more} more`) : "");
}
