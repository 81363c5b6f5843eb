// Connects the parts of the page: the picture, its status, the camera, the maps.
import { $, digits, reveal, show } from "./dom.js";
import { hand } from "./hand.js";
import { explain, stayInside, step } from "./pixel.js";
import { setSize, size } from "./picture.js";
import { count, errors } from "./problems.js";
import { ask, connect, on, remember } from "./server.js";
import "./comparison.js";
import "./models.js";
import "./host.js";

const patience = 300; // milliseconds in which most pictures are drawn
const hint = [...$("hover").childNodes];
let scene = null, pointed = null, news = "", shown = 0, timer = 0; // shown: the version whose picture has come

on("open", () => say("Connected."));
on("closed", reason => {
  document.body.classList.add("apart");
  shown = 0;
  say(reason);
});

on("scene", message => {
  scene = message;
  document.body.classList.remove("apart");
  $("title").textContent = scene.path.split(/[\\/]/).pop();
  $("title").title = scene.path;
  document.title = `${$("title").textContent} – RayCaster live`;
  if (scene.width > 0) {
    setSize(scene.shownWidth, scene.shownHeight);
    stayInside();
  }
  const isSmaller = scene.shownWidth !== scene.width || scene.shownHeight !== scene.height;
  const smaller = isSmaller ? `, shown as ${scene.shownWidth} × ${scene.shownHeight}` : "";
  const found = errors(scene);
  news = scene.good
    ? `Up to date: ${scene.width} × ${scene.height} pixels${smaller}, ${count(scene.modelCount, "model")}.`
    : scene.isGone ? `${scene.path} is gone.` : `${count(found.length + scene.more, "error")} in ${scene.path}: ${found[0].message}`;
  if (!scene.good || shown === scene.version) say(news);
  else {
    clearTimeout(timer);
    timer = setTimeout(say, patience, "Drawing …");
  }
  point();
  const picture = `The picture of ${scene.path}, ${scene.width} by ${scene.height} pixels, ${count(scene.modelCount, "model")}` +
    (scene.good ? "" : "; it is the last good one");
  for (const id of ["picture", "stage"]) $(id).setAttribute("aria-label", picture);
});

on("camera", message => {
  const { position, target, fovY } = message;
  $("camera-json").textContent = `"position": [${position.join(", ")}],\n"target": [${target.join(", ")}],\n"fovY": ${fovY}`;
  $("camera-write").disabled = $("camera-reset").disabled = !message.moved;
  remember("camera", message.moved ? { position, target } : null);
  if (message.moved) $("camera-said").textContent = ""; // it was about another camera
});

on("written", message => {
  $("camera-said").textContent = message.problem || "Written into the scene file.";
});

$("camera-copy").addEventListener("click", async () => {
  try {
    await navigator.clipboard.writeText($("camera-json").textContent);
    $("camera-said").textContent = "Copied.";
  } catch {
    getSelection().selectAllChildren($("camera-json"));
    $("camera-said").textContent = "The browser does not allow the page to copy. The text is selected: copy it.";
  }
});
$("camera-write").addEventListener("click", () => ask({ write: scene.version }));
$("camera-reset").addEventListener("click", () => ask({ camera: null }));

// What is said about a pixel and about the picture is no longer true while the camera moves.
$("stage").addEventListener("frame", ({ detail: { isFinal, version, width } }) => {
  $("view").classList.toggle("moving", !isFinal);
  if (!isFinal) {
    if (width < size.width) say("The camera moves; the picture is sharp again when it rests.");
    return;
  }
  shown = version;
  if (version === scene.version) say(news);
  point();
});

on("hover", at => {
  $("hover").textContent = `column ${at.column}, line ${at.line} (row ${at.row}): ` +
    `${at.model}, t = ${digits(at.t)}, depth z = ${digits(at.depth)}, bytes ${at.bytes.join(" ")}`;
});
hand.onPoint = pixel => {
  $("hover").setAttribute("aria-live", "off"); // a screen reader would read without end while the pointer moves
  pointed = pixel ?? pointed;
  if (pixel) ask({ hover: pixel });
};

/** Asks again about the pixel that somebody points at. */
function point() {
  if (!pointed) return;
  if (pointed[0] < size.width && pointed[1] < size.height) ask({ hover: pointed });
  else $("hover").replaceChildren(...hint);
}

hand.onClick = explain;
hand.onStep = ([right, up]) => $("arrows-step").checked && step(right, -up);

$("map-kind").addEventListener("change", event => {
  const kind = event.target.value;
  ask({ map: kind || null });
  $("map-strength").disabled = !kind;
  if (!kind) ["map", "legend", "legend-words"].forEach(id => show($(id), false));
});
$("map-strength").addEventListener("input", event => { $("map").style.opacity = event.target.value / 100; });

on("legend", legend => {
  if (!$("map-kind").value) return; // it was chosen, and is no longer
  const isRamp = legend.colors.length > 0 && legend.map !== "model";
  $("legend-words").textContent = `${legend.map === "model" ? "Each model has the colour beside its name. " : ""}Black: the ray hits nothing.`;
  show($("legend-words"), true);
  show($("legend"), isRamp);
  if (!isRamp) return;
  $("legend-from").textContent = `${legend.map} = ${digits(legend.least)}`;
  $("legend-to").textContent = digits(legend.greatest);
  $("legend-bar").style.background = `linear-gradient(to right, ${legend.colors.join(", ")})`;
});

function say(text) {
  clearTimeout(timer);
  if ($("status").textContent !== text) $("status").textContent = text;
}

/** A link that leads to a pixel: #pixel=250,350. */
function followLink() {
  const [, column, line] = /^#pixel=(\d+),(\d+)$/.exec(location.hash) ?? [];
  if (column !== undefined) explain([Math.min(Number(column), size.width - 1), Math.min(Number(line), size.height - 1)]);
}
addEventListener("hashchange", followLink);
$("stage").addEventListener("frame", followLink, { once: true });

say("Loading …");
connect();
