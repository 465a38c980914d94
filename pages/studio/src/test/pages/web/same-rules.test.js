/** The web edition answers requests for files by the rules of the studio. */
import assert from 'node:assert/strict';
import { quick } from '../tests.js';
import { openStudio, openWebEdition } from '../user.js';

const PROGRAM = 'public class Ada {}\n';
const MOTION = `500${' 0'.repeat(22)}\n`;

/** Requests in order; a known version is that of the last answer unless it is given. */
const FILES = [
  ['GET', 'programs/own/Ada.java'],
  ['PUT', 'programs/own/Ada.java', { body: PROGRAM, known: '' }],
  ['GET', 'programs/own/Ada.java'],
  ['PUT', 'programs/own/Ada.java', { body: `${PROGRAM}// changed\n` }],
  ['PUT', 'programs/own/Ada.java', { body: PROGRAM, known: 'another' }],
  ['PUT', 'programs/own/Ada.java', { body: `${PROGRAM}// changed\n`, known: 'another' }],
  ['PUT', 'programs/own/Ada.java', { body: PROGRAM, known: '' }],
  ['PUT', 'programs/draft/Ada.java', { body: PROGRAM, known: '' }],
  ['GET', 'programs/draft/Ada.java'],
  ['PUT', 'programs/draft/Ada.java', { body: `${PROGRAM}//`, known: 'another' }],
  ['DELETE', 'programs/draft/Ada.java', { known: 'another' }],
  ['GET', 'programs/draft/Ada.java'],
  ['DELETE', 'programs/draft/Ada.java'],
  ['GET', 'programs/draft/Ada.java'],
  ['PUT', 'programs/own/a%20b.java', { body: PROGRAM, known: '' }],
  ['PUT', 'programs/own/CON.java', { body: PROGRAM, known: '' }],
  ['PUT', 'programs/own/..%2FAda.java', { body: PROGRAM, known: '' }],
  ['PUT', `programs/own/${'A'.repeat(80)}.java`, { body: PROGRAM, known: '' }],
  ['PUT', `programs/own/${'A'.repeat(81)}.java`, { body: PROGRAM, known: '' }],
  ['GET', 'programs/own/Nobody.java'],
  ['GET', 'programs/example/Agent_Wave'],
  ['GET', 'programs/example/Agent_Nobody'],
  ['GET', 'programs/new/Ada.java?example=Agent_Wave'],
  ['GET', 'programs/new/Ada.java?example=Agent_Nobody'],
  ['GET', 'programs/history/Ada.java'],
  ['PUT', 'programs/history/Ada.java', { body: '["a"]' }],
  ['GET', 'programs/history/Ada.java'],
  ['GET', 'programs/unknown/Ada.java'],
  ['PUT', 'motions/bend', { body: MOTION, known: '' }],
  ['PUT', 'motions/bend', { body: MOTION, known: 'another' }],
  ['PUT', 'motions/bend', { body: `${MOTION}// changed\n`, known: 'another' }],
  ['GET', 'motions/bend'],
  ['GET', 'motions/nobody'],
  ['PUT', 'motions/a%2Fb', { body: MOTION, known: '' }],
  ['PUT', 'motions/CON', { body: MOTION, known: '' }],
  ['PUT', 'drafts/bend', { body: MOTION }],
  ['GET', 'drafts/bend'],
  ['DELETE', 'drafts/bend'],
  ['GET', 'drafts/bend'],
  ['GET', 'library/wave'],
  ['GET', 'library/nobody'],
  ['PUT', 'poses', { body: 'look 0' }],
  ['GET', 'poses'],
  ['POST', 'trial', { body: 'nonsense' }],
];

/** Sends the requests from the page, and returns status and text of each answer. */
async function answers({ user }) {
  user.expectsComplaints(/Failed to load resource/);
  return user.page.evaluate(async (requests) => {
    const seen = [];
    let version = '';
    for (const [method, place, { body, known = version } = {}] of requests) {
      const answer = await fetch(`api/${place}`, { method, body, headers: { 'Known-Version': known } });
      version = answer.headers.get('Version') ?? version;
      seen.push({ request: `${method} ${place}`, status: answer.status, text: await answer.text() });
    }
    return seen;
  }, FILES);
}

quick('requests for programs and motions have the same results', async (t) => {
  const studio = await answers(await openStudio(t, { room: 'program' }));
  const page = await answers(await openWebEdition(t, { to: '#program' }));

  const results = (all) =>
    all.map(({ request, status, text }) => `${request}: ${status} ${status < 300 ? text.slice(0, 300) : ''}`);
  assert.deepEqual(results(page), results(studio));
});
