/** Exports of recordings: a table, a self-contained page, a SimSpark server log. */
import { RecordingWriter } from '../state/replay/recording-writer.js';
import { mainRoster, tableHead, tableRows } from '../state/replay/table.js';

/**
 * @typedef {import('./recordings.js').RecordingFile} RecordingFile
 * @typedef {import('../state/kinematics.js').RobotModel} RobotModel
 * @typedef {(part: number) => void} Progress called with the completed fraction, 0 to 1; may throw to cancel
 * @typedef {[from: number, to: number]} Section indices of the first and the last moment
 */

/** Size limit for the recording embedded in a page, per minute of the run; scripts and styles add about one megabyte to the page. */
const MAX_BYTES_PER_MINUTE = 2_000_000;
const MOMENTS_PER_MINUTE = 3000;
const LETTERS_PER_BYTE = 4 / 3;

/**
 * @param {RecordingFile} file
 * @param {Record<string, RobotModel>} shippedModels
 * @param {Section} section
 * @param {Progress} progress
 * @returns {Promise<Blob>}
 */
export async function tableOf({ run }, shippedModels, [from, to], progress) {
  const models = { ...shippedModels, ...run.summary.models };
  const robots = mainRoster(run.summary.rosters);
  const parts = [tableHead(robots, models)];
  let done = 0;
  for await (const moments of run.all(from, to)) {
    parts.push(tableRows(moments, robots, models));
    done += moments.length;
    progress(done / (to + 1 - from));
  }
  return new Blob(parts, { type: 'text/csv' });
}

/**
 * @param {RecordingFile} file
 * @param {Record<string, RobotModel>} models
 * @param {Section} section
 * @param {Progress} progress
 * @returns {Promise<Blob>}
 */
export async function pageOf(file, models, section, progress) {
  const { standalonePage } = await import('./standalone.js');
  const maxBytes = (MAX_BYTES_PER_MINUTE * (section[1] + 1 - section[0])) / MOMENTS_PER_MINUTE / LETTERS_PER_BYTE;
  let packed = await shortened(file, models, section, 1, progress);
  for (let every = 2; packed.length > Math.max(maxBytes, MAX_BYTES_PER_MINUTE / 10) && every <= 8; every *= 2) {
    packed = await shortened(file, models, section, every, progress);
  }
  const page = await standalonePage({ packed, name: file.name, pictures: file.pictures }, models);
  return new Blob([page], { type: 'text/html' });
}

/**
 * @param {RecordingFile} file
 * @param {Record<string, RobotModel>} models
 * @param {Section} section
 * @param {number} every number of moments combined into one
 * @param {Progress} progress
 * @returns {Promise<Uint8Array>} the section as a gzip-compressed recording
 */
async function shortened({ run }, models, [from, to], every, progress) {
  const writer = new RecordingWriter(run.header, (type) => models[type].hinges.length);
  let index = from;
  for await (const moments of run.all(from, to)) {
    for (const moment of moments) {
      if ((index - from) % every === 0) {
        const now = index;
        writer.write(
          moment,
          run.events.filter((event) => event.index >= now && event.index < now + every),
        );
      }
      index++;
    }
    progress((index - from) / (to + 1 - from));
  }
  const packed = new Blob([writer.bytes]).stream().pipeThrough(new CompressionStream('gzip'));
  return new Uint8Array(await new Response(packed).arrayBuffer());
}
