// A service worker: keeps the site's files for times without a network. The build writes above this line their names, and a version that changes
// with them.
const place = `raycaster ${registration.scope} `; // other sites of the same server have caches, too
const name = place + version;
const requests = files.map(file => new Request(file, { cache: "no-cache" })); // the browser may still hold older ones

addEventListener("install", event => event.waitUntil(caches.open(name).then(cache => cache.addAll(requests)).then(skipWaiting)));
addEventListener("activate", event => event.waitUntil(caches.keys().then(all =>
  Promise.all(all.filter(other => other.startsWith(place) && other !== name).map(other => caches.delete(other))))));
addEventListener("fetch", event => event.respondWith(caches.match(event.request.mode === "navigate" ? "./" : event.request, { cacheName: name })
  .catch(() => null).then(kept => kept ?? fetch(event.request)))); // a browser may have thrown the files away
