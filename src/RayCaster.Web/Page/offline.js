// A service worker: keeps the files of the site, so that the page works without a network after the first load. The build writes their names, and
// a version that is another one if a file is, above this line.
const place = `raycaster ${registration.scope} `; // other sites of the same server have caches, too
const name = place + version;

addEventListener("install", event => event.waitUntil(caches.open(name).then(cache =>
  cache.addAll(files.map(file => new Request(file, { cache: "no-cache" })))))); // the browser may still hold older ones

addEventListener("activate", event => event.waitUntil(caches.keys().then(all =>
  Promise.all(all.filter(other => other.startsWith(place) && other !== name).map(other => caches.delete(other))))));

addEventListener("fetch", event => event.respondWith(caches.open(name)
  .then(cache => cache.match(event.request.mode === "navigate" ? "./" : event.request)).then(kept => kept ?? fetch(event.request))));

addEventListener("message", () => skipWaiting());
