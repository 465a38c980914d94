/** Compressed text and its representation in links (base64url). */

/** Maximum size in bytes, before and after compression. */
export const MAX_BYTES = 1_000_000;

/** Thrown for text that exceeds the maximum size. */
export class TooLarge extends Error {}

/** @param {ReadableStream<any>} stream @returns {Promise<Uint8Array<ArrayBuffer>>} */
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
      throw new TooLarge();
    }
    parts.push(value);
  }
}

/** @param {string} text @param {CompressionFormat} format */
export const compress = (text, format) => bytesOf(new Blob([text]).stream().pipeThrough(new CompressionStream(format)));

/**
 * @param {Uint8Array<ArrayBuffer>} bytes
 * @param {CompressionFormat} format
 * @returns {Promise<string>}
 * @throws {Error} if the bytes are damaged or too large
 */
export async function decompress(bytes, format) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format));
  return new TextDecoder('utf-8', { fatal: true }).decode(await bytesOf(stream));
}

/** @param {Uint8Array} bytes @returns {string} */
export function toBase64Url(bytes) {
  const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
  return btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

/** @param {string} text @returns {Uint8Array<ArrayBuffer>} @throws {Error} if it is not base64url */
export const fromBase64Url = (text) =>
  Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
