// Shows the frames, and finds the pixel at a place of the page.
import { $, show } from "./dom.js";
import { ask, on } from "./server.js";

const layers = ["picture", "map", "mine", "difference", "objects"];
const kept = {};                                  // the last frame of each layer over the picture
const canvases = { picture: $("picture"), map: $("map"), mine: $("mine") };
const contexts = Object.fromEntries(Object.entries(canvases).map(([name, canvas]) =>
  [name, canvas.getContext("2d", { willReadFrequently: true })])); // pixels in memory: putImageData is then a plain copy

/** The size at which the scene is shown, in pixels of the picture. */
export const size = { width: 1, height: 1 };

let count = 0; // frames so far

on("frame", frame => {
  const name = layers[frame.layer];
  if (name === "picture") {
    paint("picture", frame);
    ask({ shown: frame.number });
    const canvas = canvases.picture;
    canvas.dataset.version = frame.version;
    canvas.dataset.frames = ++count;
    canvas.dataset.final = frame.isFinal;
    if (!frame.isFinal) show(canvases.map, false); // it belongs to another camera
    $("stage").dispatchEvent(new CustomEvent("frame", { detail: frame }));
  } else {
    kept[name] = frame;
    if (name === "map") {
      paint("map", frame);
      show(canvases.map, $("map-kind").value !== "");
    } else if (name === overlay) lay(name);
  }
});

let overlay = null; // the layer on the canvas "mine"

/** Lays the user's picture, the difference or nothing over the scene's picture. */
export function lay(name) {
  overlay = name;
  if (name && kept[name]) paint("mine", kept[name]);
  show(canvases.mine, Boolean(name && kept[name]));
}

/** Forgets a layer until it comes again. */
export function forget(name) {
  delete kept[name];
  if (name === overlay) lay(name);
}

/** Sets the size of the picture on the page; a frame of a moving camera may have fewer pixels. */
export function setSize(width, height) {
  Object.assign(size, { width, height });
  const stage = $("stage");
  stage.style.aspectRatio = `${width} / ${height}`;
  stage.style.setProperty("--width", `${width}px`);
  stage.style.setProperty("--ratio", width / height);
}

/** The pixel at a place of the window; null outside of the picture. */
export function pixelAt(clientX, clientY) {
  const box = canvases.picture.getBoundingClientRect();
  const [column, line] = [Math.floor((clientX - box.left) / box.width * size.width), Math.floor((clientY - box.top) / box.height * size.height)];
  return column >= 0 && line >= 0 && column < size.width && line < size.height ? [column, line] : null;
}

/** Puts the marker at a pixel, or takes it away. */
export function mark(pixel) {
  const marker = $("marker");
  show(marker, pixel !== null);
  if (pixel === null) return;
  marker.style.left = `${(pixel[0] + 0.5) / size.width * 100}%`;
  marker.style.top = `${(pixel[1] + 0.5) / size.height * 100}%`;
}

function paint(name, frame) {
  const canvas = canvases[name];
  if (canvas.width !== frame.width || canvas.height !== frame.height) [canvas.width, canvas.height] = [frame.width, frame.height];
  contexts[name].putImageData(frame.image, 0, 0);
}
