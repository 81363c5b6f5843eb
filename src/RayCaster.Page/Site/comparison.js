// The user's own picture beside the scene's: one that was dropped or chosen, or a file that the program watches.
import { sendPicture } from "./connection.js";
import { $, lines, reveal, show } from "./dom.js";
import { forget, lay } from "./picture.js";
import { explain } from "./pixel.js";
import { ask, on } from "./server.js";

export const dropped = { onFile: send }; // what to do with a file that is dropped on the page

let middle = null, isDiagnosing = false, isNew = false; // isNew: somebody has just given the picture

on("scene", ({ good }) => { // a new comparison follows
  if (!good || $("compared").hidden) return;
  $("mine-said").textContent = "Comparing again …";
  $("diagnose").disabled = true;
});

on("comparison", message => {
  const name = message.name;
  $("mine-said").textContent = message.problem ? `${name}: ${message.problem}` : name ? `${name} is compared: ${message.verdict}.` : "";
  show($("compared"), Boolean(name) && !message.problem);
  $("compare-text").replaceChildren(...lines(message.text ?? ""));
  show($("diagnosis-text"), false);
  middle = message.middle;
  show($("mine-worst"), middle !== null);
  for (const option of $("mine-show").options) option.disabled = !message.hasLayers && option.value !== "none";
  if (!message.hasLayers) $("mine-show").value = "none";
  diagnosing(false);
  forget("objects");
  arrange();
  if (isNew) reveal($("comparison"));
  isNew = false;
});

on("diagnosis", message => {
  $("diagnosis-text").replaceChildren(...lines(message.text));
  show($("diagnosis-text"), true);
  diagnosing(false);
});

on("refused", ({ name, problem }) => { $("mine-said").textContent = `${name}: ${problem}`; });

on("closed", () => diagnosing(false));

$("mine-show").addEventListener("change", arrange);
$("mine-forget").addEventListener("click", () => ask({ forgetMine: true }));
$("mine-worst").addEventListener("click", () => {
  $("pixel").focus({ preventScroll: true });
  explain(middle);
});
$("diagnose").addEventListener("click", () => isDiagnosing ? ask({ diagnose: false }) : diagnose());
$("hint").addEventListener("change", event => {
  ask({ hint: event.target.value });
  if (!$("diagnosis-text").hidden) diagnose();
});

/** Changes what the button does: it starts a diagnosis, or ends the one that runs. */
function diagnosing(runs) {
  isDiagnosing = runs;
  $("diagnose").textContent = runs ? "Cancel" : "Diagnose";
  show($("diagnosing"), runs);
}

function diagnose() {
  diagnosing(true);
  $("diagnosis-text").textContent = "Drawing the scene with each known mistake …";
  show($("diagnosis-text"), true);
  reveal($("diagnosis-text"));
  ask({ hint: $("hint").value, diagnose: true });
}

/** Lays the chosen picture over the scene's. */
function arrange() {
  lay($("mine-show").value === "none" ? null : $("mine-show").value);
}

async function send(file) {
  isNew = true;
  $("mine-said").textContent = `Comparing ${file.name} …`;
  const problem = await sendPicture(file).catch(() => "it cannot be read");
  if (problem) $("mine-said").textContent = `${file.name}: ${problem}`;
}

$("mine-file").addEventListener("change", event => {
  if (event.target.files[0]) send(event.target.files[0]);
  event.target.value = ""; // so that the same file can be chosen again
});
addEventListener("dragover", event => {
  if (!event.dataTransfer.types.includes("Files")) return; // text, which a field may take
  event.preventDefault();
  document.body.classList.add("dropping");
});
addEventListener("dragleave", event => { if (!event.relatedTarget) document.body.classList.remove("dropping"); });
addEventListener("drop", event => {
  if (!event.dataTransfer.files[0]) return;
  event.preventDefault();
  document.body.classList.remove("dropping");
  dropped.onFile(event.dataTransfer.files[0]);
});
