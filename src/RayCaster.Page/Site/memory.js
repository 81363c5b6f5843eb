// What this tab remembers when it is loaded again. A browser may refuse that, or have no room left; then the page works without it.

/** Remembers a text; false if the browser does not. Then it has no older one either. */
export function keep(name, text) {
  try {
    sessionStorage.removeItem(name);
    sessionStorage.setItem(name, text);
    return true;
  } catch {
    return false;
  }
}

/** The text, or null. */
export function kept(name) {
  try {
    return sessionStorage.getItem(name);
  } catch {
    return null;
  }
}

/** Changes the address that the browser shows; some frames do not allow it. */
export function readdress(address) {
  try {
    history.replaceState(null, "", address);
  } catch { /* the old address stays */ }
}
