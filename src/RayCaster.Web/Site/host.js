// What only the page without a server has: the scene's text in an editor, scenes in files and links, and work without a network.
import { dropped } from "./comparison.js";
import { change, scene } from "./connection.js";
import { $, make, show } from "./dom.js";
import { cannot, isLink, longest, toLink } from "./link.js";
import "./problems.js"; // it makes its part before this is added
import { on } from "./server.js";

const most = 10_000_000; // letters of a scene
const editor = $("scene-text"), said = $("scene-said");
let timer = 0, camera = null, pixel = null;

for (const id of ["scene", "pixel-share"]) show($(id), true);
$("problem-list").setAttribute("role", "status"); // an alert would interrupt whoever types

on("open", () => { editor.value ||= scene[1]; });
on("scene", ({ good, problems }) => {
  editor.setAttribute("aria-invalid", !good);
  problems.forEach(({ place }, i) => {
    const [, line, column] = /:(\d+):(\d+)$/.exec(place) ?? [];
    if (line) $("problem-list").children[i].append(make("button", { type: "button", onclick: () => goTo(line, column) }, `Go to line ${line}`));
  });
});
on("text", ({ text }) => take(text)); // the camera was written into it

editor.addEventListener("input", () => {
  clearTimeout(timer);
  if (editor.value !== scene[1]) $("status").textContent = "Drawing …"; // what it said is about the old text
  timer = setTimeout(() => take(editor.value), 300);
});

editor.addEventListener("change", () => { if (editor.value !== scene[1]) take(editor.value); }); // before a button works with the old text

/** Shows a scene. */
function take(text, name = scene[0]) {
  clearTimeout(timer);
  if (text.length > most) return void (said.textContent = `${name} is too large: this page takes scenes of at most 10 MB.`);
  if (editor.value !== text) editor.value = text;
  show($("share-link"), false);
  said.textContent = $("notice").textContent = "";
  change(name, text);
}

/** Moves the caret to a place of the text. */
function goTo(line, column) {
  const at = editor.value.split("\n", line - 1).reduce((sum, { length }) => sum + length + 1, column - 1);
  editor.setSelectionRange(at, at);
  editor.focus();
}

function open(file) { // a letter has four bytes at most
  file.slice(0, 4 * most).text().then(text => take(text, file.name), () => { said.textContent = `${file.name} cannot be read.`; });
}

$("open-scene").addEventListener("change", event => {
  [...event.target.files].forEach(open);
  event.target.value = ""; // so that the same file can be chosen again
});
const { onFile } = dropped;
dropped.onFile = file => file.name.toLowerCase().endsWith(".json") ? open(file) : onFile(file);

$("save-scene").addEventListener("click", () => {
  try {
    make("a", { download: scene[0], href: URL.createObjectURL(new Blob([editor.value], { type: "application/json" })) }).click();
  } catch {
    editor.select();
    said.textContent = "The browser does not allow the page to save a file. The text is selected: copy it.";
  }
});

/** Copies a link to the scene, or shows it to be copied; with a pixel, to that pixel as the camera sees it now. */
async function share(said, field, pixel = null) {
  const link = cannot ?? await toLink(editor.value, pixel && camera?.moved ? camera : null, pixel);
  const isLink = !cannot && link.length <= longest;
  show(field, isLink);
  field.value = link;
  field.select();
  const isCopied = isLink && await navigator.clipboard?.writeText(link).then(() => true, () => false);
  said.textContent = isCopied ? "The link is copied."
    : isLink ? `The link is selected: ${matchMedia("(pointer: coarse)").matches ? "hold a finger on it, and choose Copy" : "copy it"}.`
    : `${cannot ?? `The link would have ${link.length} characters; many programs cut it.`} Save the scene as a file instead.`;
}

$("share-scene").addEventListener("click", () => share(said, $("share-link")));

on("camera", message => { camera = message; });
on("explanation", ({ column, line }) => {
  pixel = [column, line];
  $("pixel-said").textContent = ""; // it was about another pixel, or another camera
  show($("pixel-link-field"), false);
});
$("pixel-link").addEventListener("click", () => share($("pixel-said"), $("pixel-link-field"), pixel));

addEventListener("hashchange", () => { if (isLink(location.href)) location.reload(); });

navigator.serviceWorker?.register("offline.js").catch(() => { /* private windows do not allow it */ });
