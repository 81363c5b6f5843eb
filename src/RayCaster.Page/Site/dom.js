// Small helpers to build the page. Text becomes text nodes, never markup.

export const $ = id => document.getElementById(id);

/** An element: make("p", { class: "note" }, "text", child …). */
export function make(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) element.addEventListener(key.slice(2), value);
    else if (value === true) element.setAttribute(key, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(key, value);
  }
  element.append(...children.filter(child => child !== null && child !== undefined));
  return element;
}

/** Shows or hides an element; changes the page only if necessary. */
export function show(element, visible) {
  if (element.hidden === visible) element.hidden = !visible;
}

/** A number for people: six significant digits and a true minus sign, as the explanations write it. */
export function digits(value, significant = 6) {
  if (typeof value === "string") return { Infinity: "∞", "-Infinity": "−∞" }[value] ?? value; // JSON has no numbers for these
  if (Array.isArray(value)) return `(${value.map(each => digits(each, significant)).join(", ")})`;
  const [mantissa, exponent] = value.toExponential(significant - 1).split("e").map(Number);
  const isPlain = exponent > -5 && exponent < significant;
  return (isPlain ? String(Number(value.toPrecision(significant))) : `${mantissa}e${exponent}`).replace(/^-/, "−");
}

/** The lines of a text. What a narrow window breaks off a line stands further right than its beginning; the rows of a table are not broken. */
export function lines(text) {
  return text.trimEnd().split("\n").map(line => {
    const isRow = /\S {2,}\S.* {2,}\S/.test(line);
    const element = make("span", { class: isRow ? "line row" : "line" }, line);
    element.style.setProperty("--indent", `${/^ */.exec(line)[0].length + 2}ch`);
    return element;
  });
}

/** Scrolls to what somebody has opened, if its beginning is not in sight. */
export function reveal(element) {
  const { top } = element.getBoundingClientRect();
  const covered = parseFloat(getComputedStyle(document.documentElement).scrollPaddingTop) || 0; // by the picture, in a narrow window
  if (top < covered || top > innerHeight * 0.7) element.scrollIntoView();
}

/** A small square of a colour. */
export function swatch(color) {
  const square = make("span", { class: "swatch", "aria-hidden": "true" });
  square.style.background = color;
  return square;
}
