/**
 * Local replacement for the recording server: forwards requests to the replay service in the world's worker, and loads bytes from this
 * browser's storage.
 */
import { requestOf, responseOf } from './page-server.js';
import { simSparkLog } from './recording-log.js';

/**
 * @param {import('./page-recordings.js').PageRecordings} recordings
 * @param {import('./world-questions.js').WorldQuestions} questions
 */
export function replayParts(recordings, questions) {
  /** @type {import('./page-server.js').Part} */
  const served = async (values, _, request) => responseOf(await recordings.answer(requestOf(request, values)));
  return {
    'GET recordings': served,
    'PUT recordings/NAME': served,
    'DELETE recordings/NAME': served,
    'GET cards/NAME': served,
    'GET index/NAME': served,
    'PUT stars/NAME': served,
    'DELETE stars/NAME': served,
    'PUT bookmarks/NAME': served,
    'DELETE bookmarks/NAME': served,
    'GET pieces/NAME': content(async ({ NAME, skip }) => (await recordings.open(NAME)).slice(skip)),
    'GET log/NAME': content(async ({ NAME }) => simSparkLog(await recordings.file(NAME))),
    'GET notes/NAME': content(async ({ NAME, skip }) =>
      new TextEncoder().encode((await recordings.open(NAME)).notes).slice(skip),
    ),
    'GET models': async () => responseOf(await questions.ask('models')),
  };
}

/** @param {(values: Record<string, any>) => Promise<BodyInit>} load @returns {import('./page-server.js').Part} */
const content = (load) => async (values) => new Response(await load(values));
