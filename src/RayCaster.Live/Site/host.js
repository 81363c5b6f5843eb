// What only the page of a server has: the scene is a file, so an error leads to its place.
import { $, make } from "./dom.js";
import "./problems.js"; // it makes its part before this is added
import { on } from "./server.js";

on("scene", ({ problems }) => problems.forEach(({ link, place }, i) => {
  const item = $("problem-list").children[i];
  if (place) item.append(make("p", {}, make("a", { href: link }, "Open in VS Code"), " or go to ", make("code", {}, place)));
}));
