/**
 * Import and export of other programs' motion files. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').MotionDocument} MotionDocument
 * @typedef {import('./foreign.js').Imported} Imported
 * @typedef {import('../decoded-text.js').DecodedText} DecodedText
 *
 * @typedef {object} Format
 * @property {string} id
 * @property {string} name display name
 * @property {string} ending file extension
 * @property {(document: MotionDocument, body: Body, start: readonly number[]) => string} write
 */
import { decodeText, encodingNote } from '../decoded-text.js';
import { isTable, readCsv, writeCsv } from './csv.js';
import { problemNotes } from './foreign.js';
import { keyframesOf } from './motion-document.js';
import { readNet, writeNet } from './motion-net.js';
import { NAO, parse, robotOf, textOf } from './motion-text.js';
import { readWebots, writeWebots } from './webots.js';

/** Extensions of files that can be imported. */
export const ENDINGS = '.motion,.mef,.txt,.csv,.tsv';

/** @type {Format[]} */
export const FORMATS = [
  {
    id: 'webots',
    name: 'Webots, Choregraphe (.motion): radians with NAO’s sign conventions',
    ending: '.motion',
    write: (document) => writeWebots(keyframesOf(document), 'nao'),
  },
  {
    id: 'original-motion',
    name: 'Original motion editor (.motion): radians with the simulator’s signs',
    ending: '.motion',
    write: (document) => writeWebots(keyframesOf(document), 'original'),
  },
  {
    id: 'original-net',
    name: 'Original motion editor (.mef): a net of keyframes',
    ending: '.mef',
    write: (document, _body, start) => writeNet(keyframesOf(document), start),
  },
  {
    id: 'original-text',
    name: 'RoboNewbie, old and new (.txt): milliseconds and degrees',
    ending: '.txt',
    write: (document) => textOf(document),
  },
  {
    id: 'csv',
    name: 'Table (.csv): milliseconds and degrees under the joints’ names',
    ending: '.csv',
    write: (document, body) => writeCsv(keyframesOf(document), body),
  },
];

/** @param {Body} body @returns {Format[]} the formats that can express a motion of the robot */
export function formatsFor(body) {
  return body.isNao ? FORMATS : FORMATS.filter(({ id }) => id === 'original-text' || id === 'csv');
}

/** Size limit for imports in bytes, equal to the server's. */
export const MAX_BYTES = 2 * 1024 * 1024;

/**
 * Reads a motion file; the format is detected from its name and first line.
 *
 * @param {string} name name of the file
 * @param {Uint8Array} bytes content
 * @param {Body} body
 * @param {readonly number[]} start angles of joints that the file lacks
 * @returns {Imported}
 * @throws {Error} if the file is not a motion or has no effect; the message is meant for the user
 */
export function readMotion(name, bytes, body, start) {
  try {
    const text = decodeText(bytes);
    const { document, notes } = readText(name, text, body, start);
    if (keyframesOf(document).length === 0) {
      throw new Error(nothingIn(document));
    }
    const inferred = encodingNote(text);
    return { document, notes: inferred === '' ? notes : [...notes, `In ${inferred}`] };
  } catch (error) {
    throw new Error(`${name} was not imported: ${/** @type {Error} */ (error).message}`, { cause: error });
  }
}

/** @param {MotionDocument} document @returns {string} why the motion has no effect; empty if it has an effect */
function nothingIn({ lines }) {
  const at = lines.findIndex((line) => line.problem);
  const found = lines[at]?.problem;
  const problem = found?.startsWith('line ') ? found : found && `line ${at + 1} of the file: ${found}`;
  const others = `The studio imports ${ENDINGS.replaceAll(',', ', ')}.`;
  return problem ? `no keyframe can be read. ${capital(problem)}. ${others}` : `it has no keyframe. ${others}`;
}

/** @param {string} text */
function capital(text) {
  return text[0].toUpperCase() + text.slice(1);
}

/** @param {string} name @param {DecodedText} decoded @param {Body} body @param {readonly number[]} start @returns {Imported} */
function readText(name, decoded, body, start) {
  const { encoding, hasByteOrderMark, content } = decoded;
  if (content.startsWith('#WEBOTS_MOTION') || /\.motion$/i.test(name)) {
    return readWebots(content, body, start);
  }
  if (/^\s*nao\s*[\r\n]/.test(content) || /\.mef$/i.test(name)) {
    return readNet(content, body, start);
  }
  if (/\.[ct]sv$/i.test(name) || isTable(content)) {
    return readCsv(content, body, start);
  }
  const document = { ...parse(content), encoding, hasByteOrderMark };
  if (robotOf(document) !== NAO) {
    throw new Error(
      `it is for the robot ${robotOf(document)}. Put it into the folder of your motions, and open it there.`,
    );
  }
  return { document, notes: problemNotes(withPlaces(document)) };
}

/** @param {MotionDocument} document @returns {MotionDocument} the document with line numbers in its error messages */
function withPlaces(document) {
  const lines = document.lines.map((line, i) =>
    line.problem ? { ...line, problem: `line ${i + 1} of the file: ${line.problem}` } : line,
  );
  return { ...document, lines };
}
