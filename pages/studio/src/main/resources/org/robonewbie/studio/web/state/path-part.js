/** Encoding of names in addresses. Pure. */

/** Characters that servers and browsers treat as path syntax or reject, with their look-alikes. @type {Record<string, string>} */
const LOOK_ALIKES = { '/': '∕', '\\': '⧵', '%': '％', '.': '․' };

/**
 * Encodes a name as a path segment. An invalid name, such as ".." or "a/b", is replaced by a look-alike, so that the server reports the
 * name instead of resolving another address.
 *
 * @param {string} name
 * @returns {string}
 */
export function pathPart(name) {
  const isDots = /^\.+$/u.test(name);
  const encodable = [...name]
    .map((sign) => (isDots || sign !== '.' ? (LOOK_ALIKES[sign] ?? visible(sign)) : sign))
    .join('');
  return encodeURIComponent(encodable);
}

/** @param {string} sign */
function visible(sign) {
  const code = sign.codePointAt(0) ?? 0;
  return code < 32 || code === 127 ? '\uFFFD' : sign;
}
