// The mistakes of the scene file and the errors of the code.
import { $, make, show } from "./dom.js";
import { on } from "./server.js";

on("scene", scene => {
  fill($("problem-list"), scene.problems, scene.more);
  const errors = mistakes(scene).length;
  $("problems-title").textContent = scene.isGone ? "The scene file is gone"
    : `The scene file has ${errors > 0 ? count(errors, "mistake") : count(scene.problems.length, "warning")}`;
  $("problems-about").textContent = scene.good ? "" : scene.width > 0 ? "The picture is the last good one." : "There is no picture yet.";
  show($("problems"), scene.problems.length > 0);
  document.body.classList.toggle("stale", !scene.good);
});

// Compiler errors come under "dotnet watch" only; a fault while a picture is drawn comes always, and has no place.
on("code", code => {
  fill($("code-list"), code.errors, code.more);
  $("code-title").textContent = `The code has ${count(code.errors.length + code.more, "error")}`;
  show($("code"), code.errors.length > 0);
});

on("open", () => show($("code"), false)); // the program may be a new one, and tells its errors again

function fill(list, problems, more) {
  list.replaceChildren(...problems.map(entry), more > 0 ? make("li", {}, `and ${more} more`) : "");
}

/** A mistake with its line and caret, a link to its place, and the place in words. */
function entry(problem) {
  return make("li", { class: problem.isError ? "error" : "warning" },
    make("p", {}, make("strong", {}, problem.isError ? "Error: " : "Warning: "), problem.message),
    problem.excerpt ? make("pre", { tabindex: 0, role: "group", "aria-label": "The place in the file" }, problem.excerpt) : null,
    problem.place
      ? make("p", {}, make("a", { href: problem.link }, "Open in VS Code"), " or go to ", make("code", {}, problem.place)) : null);
}

export function mistakes(scene) {
  return scene.problems.filter(problem => problem.isError);
}

export function count(number, noun) {
  return `${number} ${noun}${number === 1 ? "" : "s"}`;
}
