/** Local replacement for the motion server: the robots, and trials on a robot with full physics. */
import { decodeText } from '../state/decoded-text.js';
import { bytesOf } from './browser-repository.js';

/** @param {import('./world-questions.js').WorldQuestions} questions */
export function motionParts(questions) {
  const describe = async (/** @type {string} */ name) => jsonOrRefusal(await questions.ask('robot', name), 404);
  return /** @satisfies {Record<string, import('./page-server.js').Part>} */ ({
    'GET robot': () => describe(''),
    'GET robot/NAME': ({ NAME }) => describe(NAME),
    'POST trial': async (_, options) => {
      const text = decodeText(await bytesOf(options)).content;
      const start = new Headers(options.headers).get('Start') ?? 'standing';
      return jsonOrRefusal(await questions.ask('motionTrial', text, start), 400);
    },
  });
}

/** @param {string} answer JSON, or a sentence that says why the request is refused @param {number} status status of a refusal */
function jsonOrRefusal(answer, status) {
  return new Response(answer, { status: answer.startsWith('{') ? 200 : status });
}
