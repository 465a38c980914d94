/** Submissions as links and files, for school classes without accounts. For the contents, see the Java class HandIn. */
import { decodeText } from '../state/decoded-text.js';
import { compress, decompress, fromBase64Url, MAX_BYTES, toBase64Url, TooLarge } from './packed-text.js';

/** @typedef {{source: string, text: string} | {source: string, trouble: string}} Received a submission, or why it cannot be read */

export const ENDING = '.robonewbie';
const MARK = 'submission=';
const FORMAT = 'gzip';
/** Maximum length of a link; mail programs break or truncate longer ones. */
const MAX_LINK = 2000;
const LINK = new RegExp(`${MARK}([\\w%=-]*)`, 'g');

const DAMAGED = 'It is incomplete or damaged. Ask for it again.';
const TOO_LARGE = `It is larger than ${MAX_BYTES / 1_000_000} MB unpacked.`;

/** @param {string} text submission as JSON @returns {Promise<Uint8Array<ArrayBuffer>>} content of a file */
export const submissionFile = (text) => compress(text, FORMAT);

/**
 * @param {Uint8Array} file content of the file
 * @param {string} page address of the page, without fragment
 * @returns {string} link with the same bytes; empty if it is longer than mail programs allow
 */
export function submissionLink(file, page) {
  const link = `${new URL('class.html', page)}#${MARK}${toBase64Url(file)}`;
  return link.length > MAX_LINK ? '' : link;
}

/** @param {string} source @param {() => Uint8Array<ArrayBuffer>} bytes @returns {Promise<Received>} */
async function received(source, bytes) {
  try {
    return { source, text: await decompress(bytes(), FORMAT) };
  } catch (failure) {
    return { source, trouble: failure instanceof TooLarge ? TOO_LARGE : DAMAGED };
  }
}

/**
 * Reads all links in a string, for example one link per line.
 *
 * @param {string} text
 * @param {string} name name of the source
 * @returns {Promise<Received[]>} the submissions; their sources include line numbers if the text has several lines
 */
export async function readLinks(text, name) {
  const lines = text.split(/\r\n?|\n/);
  const found = lines.flatMap((line, index) =>
    [...line.matchAll(LINK)].map(([, code]) =>
      received(lines.length > 1 ? `${name}, line ${index + 1}` : name, () => fromBase64Url(decodeURIComponent(code))),
    ),
  );
  return Promise.all(found);
}

/** @param {File} file a submission, or a text file with links @returns {Promise<Received[]>} */
export async function readFile(file) {
  const { name, size } = file;
  if (!name.endsWith(ENDING)) {
    const found =
      size > 16 * MAX_BYTES ? [] : await readLinks(decodeText(new Uint8Array(await file.arrayBuffer())).content, name);
    return found.length > 0 ? found : [{ source: name, trouble: 'It contains no submission.' }];
  }
  if (size > MAX_BYTES) {
    return [{ source: name, trouble: TOO_LARGE }];
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  return [await received(name, () => bytes)];
}
