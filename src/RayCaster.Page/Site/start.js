// Says why the page cannot start. It is no module: in a frame without an origin, and in a page that was opened as a file, no module runs.
const policies = []; // those that have forbidden something here
addEventListener("securitypolicyviolation", ({ originalPolicy }) => policies.push(originalPolicy));
addEventListener("error", ({ target }) => {
  if (target.localName === "script") reason().then(text => { document.getElementById("status").textContent = text; });
}, true);

async function reason() {
  const address = location.href.split("#")[0];
  if (location.protocol === "file:") return "This page was opened as a file: its folder has to be on a web server.";
  if (origin === "null" && self !== top) return `This page stands in a frame that forbids it to work: open ${address} in a tab of its own.`;
  if (origin === "null") return "This page is in a sandbox, where it cannot work. If a new tab with its address says this, too, its host's policy " +
    `(Content-Security-Policy) must not have "sandbox".`;
  return await lacks() ?? "This page cannot start: this browser does not run its scripts.";
}

/** What the host does that keeps the page from starting; null if nothing is known. */
async function lacks() {
  const ask = (file, method) => fetch(file, { method, cache: "no-cache" }).catch(() => null);
  const list = await (await ask("offline.js", "GET"))?.text(); // a site for times without a network lists its files there
  const files = JSON.parse(/files = (\[.*?\])/s.exec(list)?.[1] ?? "null") ?? Array.from(document.scripts, script => script.getAttribute("src"));
  const answers = await Promise.all(files.map(async file => {
    const answer = await ask(file, "HEAD");
    return { file, answer: answer?.ok ? answer : await ask(file, "GET") }; // some hosts know no HEAD
  }));
  const names = found => found.slice(0, 3).map(({ file }) => file).join(", ") + (found.length > 3 ? `, and ${found.length - 3} more files` : "");

  const missing = answers.filter(({ answer }) => answer && !answer.ok);
  const framework = answers.filter(({ file }) => file.startsWith("_"));
  const hint = framework.length > 0 && framework.every(each => missing.includes(each))
    ? " GitHub Pages leaves out _framework unless the file .nojekyll is beside it." : "";
  if (missing.length > 0) return `This page is not complete: its host does not have ${names(missing)}.${hint}`;

  const [other] = answers.filter(({ file, answer }) => answer && !isFile(file, answer));
  if (other) {
    const type = typeOf(other.answer);
    const alike = answers.filter(({ file, answer }) => answer && typeOf(answer) === type && !isFile(file, answer));
    return `This page cannot start: its host sends ${names(alike)} as ${type || "files without a type"}. ` +
      (type.includes("html") ? "That is another page, perhaps for a login." : "Browsers run scripts as text/javascript only.");
  }

  for (const policy of [...policies, ...answers.map(({ answer }) => answer?.headers.get("Content-Security-Policy"))]) {
    const need = policy && forbidden(policy);
    if (need) return `This page cannot start: its host's policy has to allow ${need}. It is "Content-Security-Policy: ${policy}".`;
  }

  const silent = answers.filter(({ answer }) => !answer);
  if (silent.length === 0) return null;
  return `This page cannot start: its host does not answer for ${names(silent)}. Is there a network, or a login in between?`;
}

const typeOf = answer => answer.headers.get("Content-Type")?.toLowerCase() ?? "";

/** Whether an answer is this file, as browsers accept it, and not a page in its place. The service worker asks, too. */
function isFile(file, answer) {
  const word = { js: "javascript", css: "css", html: "html", "/": "html" }[file.split(".").pop()];
  return word ? typeOf(answer).includes(word) : !typeOf(answer).includes("html");
}

/** What the page needs and a policy does not allow; undefined if it allows all. */
function forbidden(policy) {
  const parts = Object.fromEntries(policy.split(/[;,]/).map(part => part.trim().split(/\s+(.*)/s)));
  return ["script-src 'self' 'wasm-unsafe-eval'", "worker-src 'self'", "connect-src 'self'"].find(need => {
    const [name, ...sources] = need.split(" "), allowed = parts[name] ?? parts["default-src"];
    return allowed !== undefined && !sources.every(source => allowed.replace("'unsafe-eval'", "'wasm-unsafe-eval'").includes(source));
  });
}
