/**
 * Client for the recordings on the studio's server.
 *
 * @typedef {{seconds: number, note: string}} Bookmark
 *
 * @typedef {object} RecordingEntry
 * @property {string} name
 * @property {number} bytes
 * @property {boolean} running
 * @property {string} agent name of the recorded agent, or empty
 * @property {boolean} ofProject whether it was recorded in this project
 * @property {boolean} starred
 * @property {Bookmark[]} bookmarks
 *
 * @typedef {object} RecordingCard summary of a recording
 * @property {number} count number of cycles
 * @property {string} left team name, or empty
 * @property {string} right
 * @property {[number, number]} score
 * @property {number} robots
 * @property {Array<{kind: string}>} events
 * @property {[number, number]} pitch
 * @property {Array<[x: number, y: number]>} ball its path
 * @property {Array<{side: number, places: Array<[x: number, y: number]>}>} ways paths of the robots
 *
 * @typedef {import('../state/replay/recorded-run.js').Growth} Growth
 * @typedef {import('../state/replay/recorded-run.js').Summary} Summary
 */
import { answer, ask } from '../live/server.js';

/**
 * Makes a change, reports any failure, and reloads the list of recordings.
 *
 * @param {() => Promise<unknown>} change
 * @param {{note: (text: string) => void, changed: () => Promise<void>}} listener
 */
export async function attempt(change, { note, changed }) {
  await change().catch((error) => note(error.message));
  await changed().catch(() => {});
}

/** @returns {Promise<{folder?: string, recordings: RecordingEntry[]}>} */
export const listRecordings = () => answer('GET recordings');

/** @param {string} name @returns {Promise<RecordingCard>} */
export const loadCard = (name) => answer('GET cards/NAME', { NAME: name });

/** @param {string} name @returns {Promise<Growth & Summary>} */
export const loadIndex = (name) => answer('GET index/NAME', { NAME: name });

/** @param {string} name @param {number} events @param {number} pieces number already known @returns {Promise<Growth>} */
export const loadGrowth = (name, events, pieces) => answer('GET index/NAME', { NAME: name, events, pieces });

/** @param {string} name @param {number} piece @param {number} skip bytes to skip @returns {Promise<Uint8Array>} */
export async function loadPiece(name, piece, skip) {
  const response = await ask('GET pieces/NAME', { NAME: name, piece, skip });
  return new Uint8Array(await response.arrayBuffer());
}

/** @returns {Promise<Record<string, import('../state/kinematics.js').RobotModel>>} */
export const loadModels = () => answer('GET models');

/** @param {string} name @returns {Promise<Blob>} the recording as a SimSpark log, gzip-compressed */
export const loadLog = async (name) => (await ask('GET log/NAME', { NAME: name })).blob();

/**
 * @param {string} name
 * @param {number} skip bytes already known
 * @returns {Promise<{lines: string, bytes: number}>} the robots' logs and drawings, one JSON object per line
 */
export async function loadNotes(name, skip) {
  const bytes = await (await ask('GET notes/NAME', { NAME: name, skip })).arrayBuffer();
  return { lines: new TextDecoder().decode(bytes), bytes: bytes.byteLength };
}

/** @param {string} from @param {string} to */
export const renameRecording = (from, to) => ask('PUT recordings/NAME', { NAME: to, was: from });

/** @param {string} name */
export const deleteRecording = (name) => ask('DELETE recordings/NAME', { NAME: name });

/** @param {string} name */
export const bringBackRecording = (name) => ask('PUT recordings/NAME', { NAME: name, removed: 'yes' });

/** @param {string} name @param {boolean} on */
export const starRecording = (name, on) => ask(on ? 'PUT stars/NAME' : 'DELETE stars/NAME', { NAME: name });

/** @param {string} name @param {Bookmark} bookmark */
export const addBookmark = (name, { seconds, note }) => ask('PUT bookmarks/NAME', { NAME: name, seconds, note });

/** @param {string} name @param {number} seconds */
export const deleteBookmark = (name, seconds) => ask('DELETE bookmarks/NAME', { NAME: name, seconds });
