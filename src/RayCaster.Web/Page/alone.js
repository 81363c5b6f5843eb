// What only the page without a server has: the scene's text in an editor, scenes in files and links, and the way to work offline.
import { change, readBack, scene } from "./connection.js";
import { $, make, show } from "./dom.js";
import { fromLink, most, toLink } from "./link.js";
import "./problems.js"; // its list is made before the buttons in it
import { on } from "./server.js";

const pause = 300;         // milliseconds without a key
const longestLink = 8_000; // characters; many programs cut a longer one
const editor = $("scene-text");
let timer = 0;

editor.after($("problems"));
$("problem-list").setAttribute("role", "status"); // an alert would interrupt whoever types

on("open", () => {
  if (editor.disabled) editor.value = scene[1];
  editor.disabled = false;
});

on("scene", ({ good, problems }) => {
  editor.setAttribute("aria-invalid", !good);
  problems.forEach(({ place }, i) => {
    const [, line, column] = /:(\d+):(\d+)$/.exec(place) ?? [];
    if (line) $("problem-list").children[i].append(make("button", { type: "button", onclick: () => goTo(line, column) }, `Go to line ${line}`));
  });
});

on("written", ({ problem }) => { if (!problem) readBack(); });
on("text", ({ text }) => take(scene[0], editor.value = text));

editor.addEventListener("input", () => {
  clearTimeout(timer);
  timer = setTimeout(() => take(scene[0], editor.value), pause);
});

/** Shows a scene. */
function take(name, text) {
  clearTimeout(timer);
  show($("share"), false);
  say(text.length > most ? "The scene is too long for this page, which takes 10 MB of text." : "");
  if (text.length <= most) change(name, text);
}

function say(text) {
  $("scene-said").textContent = text;
}

/** Moves the caret to a place of the text. */
function goTo(line, column) {
  const before = editor.value.split("\n").slice(0, line - 1);
  const at = before.join("\n").length + (before.length > 0) + Number(column) - 1;
  editor.setSelectionRange(at, at);
  editor.focus();
}

async function open(file) {
  try {
    if (file.size > most) say(`${file.name} is too long for this page, which takes 10 MB of text.`);
    else take(file.name, editor.value = await file.text());
  } catch {
    say(`${file.name} cannot be read.`);
  }
}

$("open-scene").addEventListener("change", event => {
  if (event.target.files[0]) open(event.target.files[0]);
  event.target.value = ""; // so that the same file can be chosen again
});
addEventListener("drop", event => {
  const file = event.dataTransfer.files[0];
  if (!file?.name.toLowerCase().endsWith(".json")) return; // a picture (comparison.js)
  event.preventDefault();
  event.stopImmediatePropagation();
  document.body.classList.remove("dropping");
  open(file);
}, { capture: true });

$("save-scene").addEventListener("click", () =>
  make("a", { download: scene[0], href: URL.createObjectURL(new Blob([editor.value], { type: "application/json" })) }).click());

$("share-scene").addEventListener("click", async () => {
  const link = location.href.split("#")[0] + await toLink(editor.value);
  const isShort = link.length <= longestLink;
  show($("share"), isShort);
  if (!isShort) return say(`The link would have ${link.length} characters, and many programs cut it. Save the scene as a file instead.`);
  $("share-link").value = link;
  try {
    await navigator.clipboard.writeText(link);
    say("The link is copied.");
  } catch {
    $("share-link").select();
    say("The browser does not allow the page to copy. The link is selected; press Ctrl + C.");
  }
});

addEventListener("hashchange", async () => {
  const text = await fromLink().catch(() => say("This link is broken: it does not hold a whole scene."));
  if (text) take("shared.json", editor.value = text);
});

/** Keeps the page for times without a network. A newer one that was loaded last time takes the place of this one now. */
async function keep() {
  const { waiting } = await navigator.serviceWorker.register("offline.js");
  navigator.serviceWorker.addEventListener("controllerchange", () => { if (waiting) location.reload(); });
  waiting?.postMessage("start");
}
if ("serviceWorker" in navigator) keep().catch(() => { /* private windows do not allow it: then the page needs the network */ });
