/** Names in addresses. Pure. */

/** Signs that servers and browsers take for parts of a path, or refuse, and what looks like them. @type {Record<string, string>} */
const TWINS = { '/': '∕', '\\': '⧵', '%': '％', '.': '․' };

/**
 * Writes a name as a part of a path. A name that cannot be one, such as ".." or "a/b", gets there as a twin that looks the same, so
 * that the server refuses it in words instead of answering for another address.
 *
 * @param {string} name
 * @returns {string}
 */
export function pathPart(name) {
  const isDots = /^\.+$/u.test(name);
  const harmless = [...name].map((sign) => (isDots || sign !== '.' ? (TWINS[sign] ?? visible(sign)) : sign)).join('');
  return encodeURIComponent(harmless);
}

/** @param {string} sign */
function visible(sign) {
  const code = sign.codePointAt(0) ?? 0;
  return code < 32 || code === 127 ? '\uFFFD' : sign;
}
