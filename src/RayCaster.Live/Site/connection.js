// The connection to the program that serves this page: a WebSocket.
import { keep, kept, readdress } from "./memory.js";

// The program's address has the token after "#". It stays in this tab: no other page and no other port gets it.
const given = /#token=(\w+)/.exec(location.hash);
if (given) {
  keep("token", given[1]);
  readdress(location.pathname);
}
const token = given?.[1] ?? /^\w+$/.exec(kept("token"))?.[0] ?? "none";
let socket = null;

/** By how much the first frame's sides are divided while the camera moves. */
export const firstDivisor = 1;

/** Opens the connection. The listener has functions for "open", "message" (a text or a buffer) and "closed". */
export function connect(listener) {
  socket = new WebSocket(`ws://${location.host}/live`, token);
  socket.binaryType = "arraybuffer";
  socket.addEventListener("open", listener.open);
  socket.addEventListener("message", event => listener.message(event.data));
  socket.addEventListener("close", () => token === "none"
    ? listener.closed("Open the address that the terminal shows: this one lacks its secret.", true)
    : listener.closed("The program has ended or is being built again. This page continues by itself when the program runs again under the same " +
      "address; otherwise open the address that the terminal shows."));
}

/** Sends one or several requests; the server takes them in order. */
export function send(requests) {
  if (socket?.readyState === WebSocket.OPEN) socket.send(JSON.stringify(requests));
}

/** Sends a picture of the user's own program. Returns why it was refused; null if it was not. */
export async function sendPicture(file) {
  try {
    const answer = await fetch(`/mine?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file, headers: { Authorization: token } });
    return answer.ok ? null : (await answer.text()).trim();
  } catch {
    return "it cannot be sent: it is too large, or the program has ended";
  }
}
