// Draws the plane through the ray and the camera's up: the clip planes and the shapes' sections, and on the ray the explanation's crossings.
import { make } from "./dom.js";

const [width, height, margin] = [640, 300, 24];

export function section(plane) {
  const box = make("figure", { class: "section" });
  const { left, right, bottom, top } = plane.view;
  const scale = Math.min((width - 2 * margin) / (right - left), (height - 2 * margin) / (top - bottom));
  const x = u => width / 2 + (u - (left + right) / 2) * scale;
  const y = v => height / 2 - (v - (bottom + top) / 2) * scale;
  const drawing = svg("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": inWords(plane) });

  for (const [clip, at] of [["zNear", plane.near], ["zFar", plane.far]]) {
    if (at === null || x(at) < 0 || x(at) > width) continue;
    drawing.append(svg("line", { class: "clip", x1: x(at), x2: x(at), y1: 0, y2: height }), text(x(at) + 3, height - 5, clip));
  }
  for (const model of plane.models) {
    const path = model.lines.map(line => line.map(([u, v], i) => `${i ? "L" : "M"}${x(u).toFixed(1)} ${y(v).toFixed(1)}`).join("")).join("");
    drawing.append(svg("path", { class: "halo", d: path }));
    const outline = svg("path", { class: "shape", d: path });
    outline.style.stroke = model.color;
    outline.append(svg("title", {}, model.name));
    drawing.append(outline);
  }
  const end = plane.crossings.find(crossing => crossing.shows);
  const far = Math.hypot(right - left, top - bottom) * 2;
  drawing.append(svg("line", { class: "ray beyond", x1: x(0), y1: y(0), x2: x(plane.direction[0] * far), y2: y(plane.direction[1] * far) }));
  if (end) drawing.append(svg("line", { class: "ray", x1: x(0), y1: y(0), x2: x(end.place[0]), y2: y(end.place[1]) }));
  drawing.append(svg("circle", { class: "eye", cx: x(0), cy: y(0), r: 4 }), text(x(0) + 6, y(0) + 14, "P"));
  for (const { place, shows, words } of plane.crossings) {
    const mark = svg("circle", { class: shows ? "crossing shows" : "crossing", cx: x(place[0]), cy: y(place[1]), r: shows ? 6 : 4 });
    mark.append(svg("title", {}, words));
    drawing.append(mark);
  }
  if (end) drawing.append(text(x(end.place[0]) + 8, y(end.place[1]) - 8, end.label));
  box.append(drawing, make("figcaption", {},
    "The plane through the ray and the camera's up (V upwards). The filled dot is the crossing that shows; rings are the others."));
  return box;
}

function inWords({ crossings }) {
  const end = crossings.find(crossing => crossing.shows);
  return `Drawing of the ray from the side: it ${end ? `ends at ${end.words}` : "hits nothing"}; ${crossings.length} crossings are marked`;
}

function svg(name, attributes = {}, content = "") {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(content);
  return element;
}

function text(x, y, content) {
  return svg("text", { x, y }, content);
}
