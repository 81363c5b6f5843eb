// The list of models, and the ledger of the rays.
import { $, make, swatch } from "./dom.js";
import { on } from "./server.js";

let scene = null, ledger = null, legend = null; // the newest of each; without a server they come from two workers, in any order

on("scene", message => {
  scene = message;
  if (!scene.models) return;
  build();
  fill();
});

on("ledger", message => {
  ledger = message;
  $("ledger-report").textContent = ledger.report;
  fill();
});

on("legend", message => {
  legend = message;
  fill();
});

$("map-kind").addEventListener("change", fill);

/** The models' names, which tell whether two messages are about the same models. */
function names(message) {
  return JSON.stringify(message?.models?.map(model => model.name));
}

/** Fills the table: the colours of the models or of their map, and how many rays each has. */
function fill() {
  if (!scene?.models) return;
  const colors = $("map-kind").value === "model" && legend?.map === "model" ? legend.colors : [];
  const isCounted = names(ledger) === names(scene);
  scene.models.forEach((model, i) => {
    const row = $(`model-${i}`);
    row.querySelector(".swatch").style.background = colors[i] ?? model.color;
    if (!isCounted) return;
    const { shows, reason } = ledger.models[i];
    const share = shows / Math.max(1, ledger.rays) * 100;
    $(`model-${i}-rays`).textContent = shows > 0 ? `${share < 0.1 ? "<\u00a00.1" : share.toFixed(1)}\u00a0%` : reason;
    row.classList.toggle("unseen", shows === 0);
  });
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
