// Says why the page cannot start. It is no module: in a frame without an origin, and in a page that was opened as a file, no module runs.
addEventListener("error", ({ target }) => {
  if (target instanceof HTMLScriptElement) reason().then(text => { document.getElementById("status").textContent = text; });
}, true);

async function reason() {
  if (location.protocol === "file:") return "This page was opened as a file: its folder has to be on a web server.";
  if (origin === "null") return `This page stands in a frame that forbids it to work: open ${location.href.split("#")[0]} in a tab of its own.`;
  return await lacks() ?? "This page cannot start: this browser does not run its scripts.";
}

/** Which of the site's files the host does not have; null if it has all. */
async function lacks() {
  const has = (file, method) => fetch(file, { method }).then(answer => answer.ok && answer, () => null);
  const list = await has("offline.js", "GET"); // a site for times without a network lists its files there
  const files = list ? JSON.parse(/files = (\[.*?\])/s.exec(await list.text())[1]) : [...document.scripts].map(script => script.getAttribute("src"));
  const answers = await Promise.all(files.map(file => has(file, "HEAD")));
  const missing = files.filter((_, i) => !answers[i]);
  const hint = missing.some(file => file.startsWith("_")) ? " GitHub Pages leaves out _framework unless the file .nojekyll is beside it." : "";
  const names = missing.slice(0, 3).join(", ") + (missing.length > 3 ? `, and ${missing.length - 3} more files` : "");
  return missing.length === 0 ? null : `This page is not complete: its host does not have ${names}.${hint}`;
}
