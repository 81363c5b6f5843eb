// A service worker: keeps the site's files for times without a network. The build writes above this line their names, and a version that changes
// with them.
importScripts("start.js"); // isFile

const place = `raycaster ${registration.scope} `; // other sites of the same server have caches, too
const name = place + version;

/** Keeps a file for ever, so it must be one that a browser takes: where the host has redirected the request, it takes a copy only. */
async function keep(file, cache) {
  const answer = await fetch(file, { cache: "no-cache" }); // the browser may still hold an older one
  if (!answer.ok || !isFile(file, answer)) throw new Error(`The host does not send ${file}.`);
  await cache.put(file, new Response(answer.body, answer));
}

addEventListener("install", event => event.waitUntil(caches.open(name).then(cache => Promise.all(files.map(file => keep(file, cache))))
  .then(skipWaiting)));
addEventListener("activate", event => event.waitUntil(caches.keys().then(all =>
  Promise.all(all.filter(other => other.startsWith(place) && other !== name).map(other => caches.delete(other))))));
addEventListener("fetch", event => event.respondWith(caches.match(event.request.mode === "navigate" ? "./" : event.request, { cacheName: name })
  .catch(() => null).then(kept => kept ?? fetch(event.request)))); // a browser may have thrown the files away
