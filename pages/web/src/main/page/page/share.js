/** Links that contain a program: its name and text, compressed, in the fragment of the page's address. Nothing is sent to a server. */

const MARK = 'shared=';
const MAX_BYTES = 1_000_000;

const DAMAGED =
  'The program in this link cannot be read: the link is incomplete or damaged. Ask for the complete link.';
const TOO_LARGE = `The program in this link is larger than ${MAX_BYTES / 1_000_000} MB, the limit for programs.`;

/** @param {ReadableStream<any>} stream @returns {Promise<Uint8Array>} */
async function bytesOf(stream) {
  const parts = [];
  let length = 0;
  for (const reader = stream.getReader(); ;) {
    const { done, value } = await reader.read();
    if (done) {
      return new Uint8Array(await new Blob(parts).arrayBuffer());
    }
    length += value.length;
    if (length > MAX_BYTES) {
      await reader.cancel();
      throw new Error(TOO_LARGE);
    }
    parts.push(value);
  }
}

/** @param {string} text */
async function packed(text) {
  const bytes = await bytesOf(new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw')));
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** @param {string} text */
async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new TextDecoder('utf-8', { fatal: true }).decode(await bytesOf(stream));
}

/** @param {string} path @param {string} text @returns {Promise<string>} fragment of a link */
export async function sharedHash(path, text) {
  return `program?${MARK}${await packed(`${path}\n${text}`)}`;
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
    const [path, ...lines] = (await unpacked(decodeURIComponent(content))).split('\n');
    if (lines.length > 0) {
      return { path, text: lines.join('\n') };
    }
  } catch (failure) {
    throw /** @type {Error} */ (failure).message === TOO_LARGE ? failure : new Error(DAMAGED, { cause: failure });
  }
  throw new Error(DAMAGED);
}
