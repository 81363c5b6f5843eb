// A scene as the part of a link behind "#": its text, packed. No server sees that part.
import { $ } from "./dom.js";

/** In characters: many programs cut a longer link. */
export const longest = 8_000;

export async function toLink(text) {
  const packed = await new Response(new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"))).arrayBuffer();
  const code = btoa(Array.from(new Uint8Array(packed), byte => String.fromCharCode(byte)).join(""));
  return `${location.href.split("#")[0]}#scene=${code.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** The name and the text of the scene in this page's address, which it leaves; nothing if there is none, or not a whole one. */
export async function fromLink() {
  if (!location.hash.startsWith("#scene=")) return;
  const code = location.hash.slice(7, longest).replaceAll("-", "+").replaceAll("_", "/"); // a few megabytes of text at most
  history.replaceState(null, "", location.pathname);
  try {
    const packed = Uint8Array.from(atob(code), character => character.charCodeAt(0));
    return ["shared.json", await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text()];
  } catch {
    $("scene-said").textContent = "This link is broken: it does not hold a whole scene.";
  }
}
