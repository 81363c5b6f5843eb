// A scene as the part of a link behind "#": its text, packed. No server sees that part.

/** The most bytes of a scene's text that the page takes. */
export const most = 10_000_000;

export async function toLink(text) {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const code = btoa(Array.from(bytes, byte => String.fromCharCode(byte)).join(""));
  return `#scene=${code.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

/** The scene of this page's address, which it leaves; null if there is none. A broken link is an error. */
export async function fromLink() {
  const [, code] = /^#scene=(.*)$/.exec(location.hash) ?? [];
  if (code === undefined) return null;
  history.replaceState(null, "", location.pathname);
  const bytes = Uint8Array.from(atob(code.replaceAll("-", "+").replaceAll("_", "/")), character => character.charCodeAt(0));
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"))
    .pipeThrough(new TextDecoderStream("utf-8", { fatal: true })).getReader();
  let text = "";
  for (let part; !(part = await reader.read()).done;) {
    text += part.value;
    if (text.length > most) throw new Error("some bytes can be packed that no memory holds");
  }
  return text;
}
