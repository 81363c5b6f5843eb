// A scene as the part of a link behind "#": its text, packed, and perhaps a camera and a pixel. No server sees that part.

/** In characters: many programs cut a longer link. */
export const longest = 8_000;

/** Why this browser can make and read no links; null if it can. */
export const cannot = globalThis.CompressionStream && globalThis.DecompressionStream ? null
  : "This browser cannot pack a scene into a link: Chrome and Edge can from version 103, Firefox from 113, Safari from 16.4.";

/** Programs that pass a link on change it: they encode "#" and "=", perhaps twice, and add what follows it in their text. */
const pattern = /(?:#|%(?:25)*23)scene(.*)$/is;

export const isLink = address => pattern.test(address);

/** A link to a scene's text, and with a camera and a pixel to what they show of it. */
export async function toLink(text, camera, pixel) {
  const packed = await new Response(new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"))).arrayBuffer();
  const code = btoa(Array.from(new Uint8Array(packed), byte => String.fromCharCode(byte)).join(""));
  const more = (camera ? `&camera=${[...camera.position, ...camera.target]}` : "") + (pixel ? `&pixel=${pixel}` : "");
  return `${new URL(".", location.href)}#scene=${code.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}${more}`;
}

/** What a link holds: the text, and perhaps a camera and a pixel; null if it holds no whole scene. */
export async function fromLink(address) {
  const rest = decoded(pattern.exec(address)[1]);
  for (const words of [rest, rest.replace(/=?\s+/g, "")]) { // perhaps it was broken into lines
    const [, code, more] = /^=?([\w+/-]*)(.*)$/s.exec(words);
    const text = await unpacked(code);
    if (text === null) continue;
    const numbers = /&camera=([-+.,\de]+)/.exec(more)?.[1].split(",").map(Number) ?? [];
    const camera = numbers.length === 6 && numbers.every(Number.isFinite) ? { position: numbers.slice(0, 3), target: numbers.slice(3) } : null;
    return { text, camera, pixel: /&pixel=(\d+,\d+)/.exec(more)?.[1] ?? null };
  }
  return null;
}

function decoded(text) {
  try {
    for (let i = 0; i < 3 && text.includes("%"); i++) text = decodeURIComponent(text);
  } catch { /* a lone "%" */ }
  return text;
}

async function unpacked(code) {
  if (!code || code.length > longest) return null; // a few megabytes of text at most
  try {
    const packed = Uint8Array.from(atob(code.replaceAll("-", "+").replaceAll("_", "/")), character => character.charCodeAt(0));
    return await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"))).text();
  } catch {
    return null;
  }
}
