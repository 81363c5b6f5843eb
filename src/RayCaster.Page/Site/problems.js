// The errors of the scene file, and a fault of the code.
import { $, make, show } from "./dom.js";
import { on } from "./server.js";

on("scene", scene => {
  fill($("problem-list"), scene.problems, scene.more);
  const found = errors(scene).length;
  $("problems-title").textContent = scene.isGone ? "The scene file is gone"
    : `The scene file has ${found > 0 ? count(found + scene.more, "error") : count(scene.problems.length, "warning")}`;
  $("problems-about").textContent = scene.good ? "" : scene.width > 0 ? "The picture is the last good one." : "There is no picture yet.";
  show($("problems"), scene.problems.length > 0);
  document.body.classList.toggle("stale", !scene.good);
});

on("fault", fault => {
  $("fault-text").textContent = fault.text;
  show($("fault"), fault.text !== null);
});

on("open", () => show($("fault"), false)); // the program may be a new one

function fill(list, problems, more) {
  list.replaceChildren(...problems.map(entry), more > 0 ? make("li", {}, `and ${more} more`) : "");
}

/** An error with its line and caret. A host adds the way to its place. */
function entry(problem) {
  return make("li", { class: problem.isError ? "error" : "warning" },
    make("p", {}, make("strong", {}, problem.isError ? "Error: " : "Warning: "), problem.message),
    problem.excerpt ? make("pre", { tabindex: 0, role: "group", "aria-label": "The place in the file" }, problem.excerpt) : null);
}

export function errors(scene) {
  return scene.problems.filter(problem => problem.isError);
}

export function count(number, noun) {
  return `${number} ${noun}${number === 1 ? "" : "s"}`;
}
