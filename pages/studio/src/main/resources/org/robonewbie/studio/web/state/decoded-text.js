/**
 * Detects the encoding of text files, decodes them, and encodes changed text in the same encoding. The rules are those of the Java class
 * DecodedText: a byte order mark takes precedence; otherwise the encoding is UTF-8, or Windows-1252 if the bytes are not valid UTF-8. Pure.
 *
 * @typedef {'UTF-8' | 'UTF-16LE' | 'UTF-16BE' | 'Windows-1252'} Encoding
 *
 * @typedef {object} Source encoding of a file
 * @property {Encoding} encoding
 * @property {boolean} hasByteOrderMark
 *
 * @typedef {Source & {content: string}} DecodedText content excludes the byte order mark
 */

/** Encoding of new files. @type {Source} */
export const UTF_8 = { encoding: 'UTF-8', hasByteOrderMark: false };

const SAVE_AS_UTF_8 = 'Save it as UTF-8 (most editors: Save As, Encoding).';
const MARK = '\uFEFF';
const MAX_LETTERS = 60;

/** Windows-1252 characters 0x80 to 0x9F; \0 for unassigned ones. */
const SIGNS =
  '\u20AC\0\u201A\u0192\u201E\u2026\u2020\u2021\u02C6\u2030\u0160\u2039\u0152\0\u017D\0' +
  '\0\u2018\u2019\u201C\u201D\u2022\u2013\u2014\u02DC\u2122\u0161\u203A\u0153\0\u017E\u0178';

/** Thrown for bytes that are not text; the message includes the line number and the remedy. */
export class UndecodableText extends Error {
  /** @param {number} line starting at 1 @param {string} problem */
  constructor(line, problem) {
    super(`line ${line} ${problem}. ${SAVE_AS_UTF_8}`);
    this.line = line;
  }
}

/**
 * @param {Uint8Array} bytes all bytes of a file
 * @returns {DecodedText}
 * @throws {UndecodableText} if the bytes are not text
 */
export function decodeText(bytes) {
  const first = bytes.length < 2 ? 0 : 256 * bytes[0] + bytes[1];
  if (first === 0xfeff || first === 0xfffe) {
    const isLittle = first === 0xfffe;
    return marked(isLittle ? 'UTF-16LE' : 'UTF-16BE', utf16(bytes, isLittle));
  }
  const unicode = utf8(bytes);
  if (unicode !== undefined) {
    return marked('UTF-8', unicode);
  }
  refuseDamagedUtf8(bytes);
  return marked('Windows-1252', windows1252(bytes));
}

/**
 * @param {Source} source encoding of the file
 * @param {string} content the changed text
 * @returns {Uint8Array<ArrayBuffer>} the text in the same encoding, or in UTF-8 if it is not representable
 */
export function encodeText(source, content) {
  const text = source.hasByteOrderMark ? MARK + content : content;
  switch (encodingFor(source, content)) {
    case 'UTF-16LE':
      return bytesOfUtf16(text, 0);
    case 'UTF-16BE':
      return bytesOfUtf16(text, 1);
    case 'Windows-1252':
      return /** @type {Uint8Array<ArrayBuffer>} */ (bytesOf1252(text));
    default:
      return new TextEncoder().encode(text);
  }
}

/** @param {Source} source @param {string} content @returns {Encoding} the encoding that {@link encodeText} uses for the text */
export function encodingFor(source, content) {
  return source.encoding === 'Windows-1252' && !bytesOf1252(content) ? 'UTF-8' : source.encoding;
}

/** @param {DecodedText} text @returns {string} how its encoding was inferred; empty if it is certain */
export function encodingNote({ encoding, content }) {
  if (encoding !== 'Windows-1252') {
    return '';
  }
  const lines = content.split(/\r\n|\r|\n/);
  const first = lines.findIndex((line) => /[^\0-\x7f]/.test(line));
  const line = lines[first].replace(/^[ \t\f]+|[ \t\f]+$/g, '');
  const shown = line.length <= MAX_LETTERS ? line : `${line.slice(0, MAX_LETTERS)}…`;
  return `line ${first + 1} is not UTF-8 and was read as Windows-1252: "${shown}". ${SAVE_AS_UTF_8}`;
}

/** @param {Uint8Array} bytes @returns {string} text for display only: undecodable bytes are replaced */
export function legibleText(bytes) {
  return new TextDecoder().decode(bytes);
}

/** @param {Encoding} encoding @param {string} decoded @returns {DecodedText} */
function marked(encoding, decoded) {
  const zero = decoded.indexOf('\0');
  if (zero >= 0) {
    throw new UndecodableText(
      lineAt(decoded, zero),
      'contains a zero byte, as in binary files and in UTF-16 without a byte order mark',
    );
  }
  const hasByteOrderMark = decoded.startsWith(MARK);
  return { encoding, hasByteOrderMark, content: hasByteOrderMark ? decoded.slice(1) : decoded };
}

/** @param {Uint8Array} bytes @returns {string | undefined} the text; undefined if the bytes are not UTF-8 */
function utf8(bytes) {
  try {
    return new TextDecoder('utf-8', { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return undefined;
  }
}

/**
 * Rejects damaged files: those with a few invalid bytes after a UTF-8 byte order mark or among many UTF-8 characters.
 *
 * @param {Uint8Array} bytes
 */
function refuseDamagedUtf8(bytes) {
  let letters = 0;
  let wrong = 0;
  let firstWrong = bytes.length;
  for (let i = 0; i < bytes.length;) {
    const length = utf8Length(bytes, i);
    letters += length > 1 ? 1 : 0;
    wrong += length === 0 ? 1 : 0;
    if (length === 0 || !isScalar(bytes, i, length)) {
      firstWrong = Math.min(firstWrong, i);
    }
    i += Math.max(1, length);
  }
  const hasMark = bytes[0] === 0xef && bytes[1] === 0xbb && bytes[2] === 0xbf;
  if (letters > wrong || hasMark) {
    const before = Array.from(bytes.subarray(0, firstWrong), (byte) => String.fromCharCode(byte)).join('');
    throw new UndecodableText(
      lineAt(before, before.length),
      'is not UTF-8, though the rest of the file is: it is damaged',
    );
  }
}

/** Returns the length of the UTF-8 sequence at an index; 0 if it is invalid. @param {Uint8Array} bytes @param {number} at */
function utf8Length(bytes, at) {
  const lead = bytes[at];
  const limits = [0x80, 0xc2, 0xe0, 0xf0, 0xf5];
  const length = [1, 0, 2, 3, 4, 0][limits.filter((limit) => lead >= limit).length];
  for (let i = at + 1; i < at + length; i += 1) {
    if (i >= bytes.length || (bytes[i] & 0xc0) !== 0x80) {
      return 0;
    }
  }
  return length;
}

/**
 * Returns whether a well-formed UTF-8 sequence is a valid character: neither a surrogate nor overlong.
 *
 * @param {Uint8Array} bytes
 * @param {number} at
 * @param {number} length
 */
function isScalar(bytes, at, length) {
  const second = bytes[at + 1];
  switch (length < 3 ? 0 : bytes[at]) {
    case 0xe0:
      return second >= 0xa0;
    case 0xed:
      return second < 0xa0;
    case 0xf0:
      return second >= 0x90;
    case 0xf4:
      return second < 0x90;
    default:
      return true;
  }
}

/** @param {Uint8Array} bytes @param {boolean} isLittle */
function utf16(bytes, isLittle) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const codes = Array.from({ length: bytes.length >> 1 }, (_, i) => view.getUint16(2 * i, isLittle));
  const text = codes.map((code) => String.fromCharCode(code)).join('');
  const unpaired = text.search(/[\uD800-\uDBFF](?![\uDC00-\uDFFF])|(?<![\uD800-\uDBFF])[\uDC00-\uDFFF]/);
  const wrong = bytes.length % 2 === 1 ? text.length : unpaired;
  if (wrong >= 0) {
    throw new UndecodableText(lineAt(text, wrong), 'ends within a UTF-16 character');
  }
  return text;
}

/** @param {string} text @param {number} low index of the low byte within its pair */
function bytesOfUtf16(text, low) {
  const bytes = new Uint8Array(2 * text.length);
  for (let i = 0; i < text.length; i += 1) {
    bytes[2 * i + low] = text.charCodeAt(i) & 0xff;
    bytes[2 * i + 1 - low] = text.charCodeAt(i) >> 8;
  }
  return bytes;
}

/** @param {Uint8Array} bytes */
function windows1252(bytes) {
  const letters = Array.from(bytes, (code) => {
    if (code >= 0x80 && code < 0xa0) {
      return SIGNS[code - 0x80];
    }
    const isControl = (code < 0x20 && ![9, 10, 12, 13].includes(code)) || code === 0x7f;
    return isControl ? '\0' : String.fromCharCode(code);
  });
  const wrong = letters.indexOf('\0');
  if (wrong >= 0) {
    const byte = bytes[wrong].toString(16).padStart(2, '0');
    const before = letters.slice(0, wrong).join('');
    throw new UndecodableText(lineAt(before, wrong), `is neither UTF-8 nor Windows-1252 (byte 0x${byte})`);
  }
  return letters.join('');
}

/**
 * @param {string} text
 * @returns {Uint8Array | undefined} the bytes; undefined if a character is not representable or if the bytes would be decoded differently
 */
function bytesOf1252(text) {
  const codes = Array.from(text, (letter) => codeOf1252(letter));
  const bytes = Uint8Array.from(codes);
  if (codes.includes(-1)) {
    return undefined;
  }
  try {
    return decodeText(bytes).content === text ? bytes : undefined;
  } catch {
    return undefined;
  }
}

/** @param {string} letter */
function codeOf1252(letter) {
  const code = letter.codePointAt(0) ?? 0;
  const sign = letter === '\0' ? -1 : SIGNS.indexOf(letter);
  if (sign >= 0) {
    return 0x80 + sign;
  }
  return code < 0x80 || (code >= 0xa0 && code <= 0xff) ? code : -1;
}

/** @param {string} text @param {number} index @returns {number} line number, starting at 1 */
function lineAt(text, index) {
  const before = text.slice(0, index);
  return (before.match(/\r\n|\r|\n/g) ?? []).length + 1;
}
