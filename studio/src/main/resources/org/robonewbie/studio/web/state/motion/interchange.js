/**
 * The files that other programs read and write. Pure.
 *
 * @typedef {import('./body.js').Body} Body
 * @typedef {import('./motion-text.js').MotionDocument} MotionDocument
 * @typedef {import('./foreign.js').Imported} Imported
 *
 * @typedef {object} Format
 * @property {string} id
 * @property {string} name for people
 * @property {string} ending of the file's name
 * @property {(document: MotionDocument, body: Body, start: readonly number[]) => string} write
 */
import { readCsv, writeCsv } from './csv.js';
import { problemNotes } from './foreign.js';
import { keyframesOf } from './motion-document.js';
import { readNet, writeNet } from './motion-net.js';
import { decode, textOf } from './motion-text.js';
import { readWebots, writeWebots } from './webots.js';

/** What an import takes. */
export const ENDINGS = '.motion,.mef,.txt,.csv,.tsv';

/** @type {Format[]} */
export const FORMATS = [
  {
    id: 'webots',
    name: 'Webots, Choregraphe (.motion): radians with NAO’s own signs',
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

/**
 * Reads any of these files; what it is is told by its name and its first line.
 *
 * @param {string} name of the file
 * @param {Uint8Array} bytes its content
 * @param {Body} body
 * @param {readonly number[]} start angles of joints of which the file says nothing
 * @returns {Imported}
 * @throws {Error} if nothing of the file is a motion; the message is meant for people
 */
export function readMotion(name, bytes, body, start) {
  const document = decode(bytes);
  const text = textOf(document).replace(/^\uFEFF/, '');
  if (text.startsWith('#WEBOTS_MOTION') || /\.motion$/i.test(name)) {
    return readWebots(text, body, start);
  }
  if (/^\s*nao\s*[\r\n]/.test(text) || /\.mef$/i.test(name)) {
    return readNet(text, start);
  }
  if (/\.[ct]sv$/i.test(name)) {
    return readCsv(text, body, start);
  }
  return { document, notes: problemNotes(withPlaces(document)) };
}

/** @param {MotionDocument} document @returns {MotionDocument} whose problems say on which line they are */
function withPlaces(document) {
  const lines = document.lines.map((line, i) =>
    line.problem ? { ...line, problem: `line ${i + 1} of the file: ${line.problem}` } : line,
  );
  return { ...document, lines };
}
