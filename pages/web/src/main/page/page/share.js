/** Links that contain a program: its name and text, compressed, in the fragment of the page's address. Nothing is sent to a server. */

import { compress, decompress, fromBase64Url, MAX_BYTES, toBase64Url, TooLarge } from './packed-text.js';

const MARK = 'shared=';
const FORMAT = 'deflate-raw';

const DAMAGED =
  'The program in this link cannot be read: the link is incomplete or damaged. Ask for the complete link.';
const TOO_LARGE = `The program in this link is larger than ${MAX_BYTES / 1_000_000} MB, the limit for programs.`;

/** @param {string} path @param {string} text @returns {Promise<string>} fragment of a link */
export async function sharedHash(path, text) {
  return `program?${MARK}${toBase64Url(await compress(`${path}\n${text}`, FORMAT))}`;
}

/** @param {string} path @param {string} text @returns {Promise<string>} the link */
export async function linkOf(path, text) {
  const address = new URL(location.href);
  address.search = '';
  address.hash = await sharedHash(path, text);
  return address.href;
}

/** @param {string} hash fragment of an address @returns {boolean} whether it contains a program */
export const isShared = (hash) => hash.includes(`?${MARK}`);

/**
 * Reads a program from the fragment of an address.
 *
 * @param {string} hash
 * @returns {Promise<{path: string, text: string}>} the program; its path is untrusted
 * @throws {Error} if it cannot be read; the message is meant for the user
 */
export async function sharedProgram(hash) {
  const [, content] = hash.split(`?${MARK}`);
  try {
    const [path, ...lines] = (await decompress(fromBase64Url(decodeURIComponent(content)), FORMAT)).split('\n');
    if (lines.length > 0) {
      return { path, text: lines.join('\n') };
    }
  } catch (failure) {
    throw new Error(failure instanceof TooLarge ? TOO_LARGE : DAMAGED, { cause: failure });
  }
  throw new Error(DAMAGED);
}
