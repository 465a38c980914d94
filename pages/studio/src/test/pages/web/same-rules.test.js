/** The web edition answers requests for files by the rules of the studio. */
import assert from 'node:assert/strict';
import { quick } from '../tests.js';
import { openStudio, openWebEdition } from '../user.js';

const PROGRAM = 'public class Ada {}\n';
const MOTION = `500${' 0'.repeat(22)}\n`;

const write = (kind, path, body, known) => ['PUT files/KIND/PATH', { KIND: kind, PATH: path }, { body, known }];
const read = (kind, path) => ['GET files/KIND/PATH', { KIND: kind, PATH: path }];
const remove = (kind, path, known) => ['DELETE files/KIND/PATH', { KIND: kind, PATH: path }, { known }];
/** Stands for the version in the last answer. */
const LAST = 'last';

/** Requests in order. */
const REQUESTS = [
  read('program', 'Ada.java'),
  write('program', 'Ada.java', PROGRAM, ''),
  read('program', 'Ada.java'),
  write('program', 'Ada.java', `${PROGRAM}// changed\n`, LAST),
  write('program', 'Ada.java', PROGRAM, 'another'),
  write('program', 'Ada.java', `${PROGRAM}// changed\n`, 'another'),
  write('program', 'Ada.java', PROGRAM, ''),
  write('program', 'Ada.java', PROGRAM),
  remove('program', 'Ada.java', LAST),
  write('program-draft', 'Ada.java', PROGRAM, ''),
  read('program-draft', 'Ada.java'),
  write('program-draft', 'Ada.java', `${PROGRAM}//`, 'another'),
  remove('program-draft', 'Ada.java', 'another'),
  read('program-draft', 'Ada.java'),
  remove('program-draft', 'Ada.java', LAST),
  read('program-draft', 'Ada.java'),
  write('program-draft', 'Ada.java', `${PROGRAM}// changed\n`, 'another'),
  write('program', 'Ada.java', `${PROGRAM}// changed\n`, ''),
  read('program-draft', 'Ada.java'),
  ...['a b', 'CON', '../Ada', 'A'.repeat(80), 'A'.repeat(81)].map((name) =>
    write('program', `${name}.java`, PROGRAM, ''),
  ),
  read('program', 'Nobody.java'),
  read('example', 'Agent_Wave'),
  read('example', 'Agent_Nobody'),
  write('example', 'Agent_Wave', PROGRAM, ''),
  ['GET programs/new/PATH', { PATH: 'Ada.java', example: 'Agent_Wave' }],
  ['GET programs/new/PATH', { PATH: 'Ada.java', example: 'Agent_Nobody' }],
  ['GET programs/new/PATH', { PATH: 'Ada$1.java', example: 'Agent_BetterSoccer' }],
  ['GET programs/new/PATH', { PATH: 'Ada.java' }],
  read('program-history', 'Ada.java'),
  write('program-history', 'Ada.java', '["a"]'),
  write('program-history', 'Ada.java', '["b"]'),
  read('program-history', 'Ada.java'),
  write('motion', 'bend', MOTION, ''),
  write('motion', 'bend', MOTION, 'another'),
  write('motion', 'bend', `${MOTION}// changed\n`, 'another'),
  read('motion', 'bend'),
  read('motion', 'nobody'),
  ...['a/b', 'CON'].map((name) => write('motion', name, MOTION, '')),
  remove('motion', 'bend', LAST),
  write('motion-draft', 'bend', MOTION),
  read('motion-draft', 'bend'),
  remove('motion-draft', 'bend'),
  read('motion-draft', 'bend'),
  read('motion-library', 'wave'),
  read('motion-library', 'nobody'),
  write('postures', 'poses', 'look 0'),
  read('postures', 'poses'),
  ['POST trial', {}, { body: 'nonsense' }],
];

/** Sends the requests from the page, and returns status and text of each answer, and why a name is refused. */
async function answers({ user }) {
  user.expectsComplaints(/Failed to load resource/);
  return user.page.evaluate(
    async (requests, last) => {
      const { ask } = await import('./live/server.js');
      const seen = [];
      let version = '';
      for (const [request, values, { body, known } = {}] of requests) {
        const headers = known === undefined ? {} : { 'Known-Version': known === last ? version : known };
        const name = `${request} ${Object.values(values).join(' ')}`;
        try {
          const answer = await ask(request, values, { body, headers });
          version = answer.headers.get('Version') ?? version;
          seen.push(`${name}: 200 ${(await answer.text()).slice(0, 300)}`);
        } catch ({ status, message }) {
          // The address of a request contains look-alikes of the dots of "..".
          seen.push(`${name}: ${status} ${status === 400 ? message.replaceAll('\u2024', '.') : ''}`);
        }
      }
      return seen;
    },
    REQUESTS,
    LAST,
  );
}

quick('requests for programs and motions have the same results', async (t) => {
  const studio = await answers(await openStudio(t, { room: 'program' }));
  const page = await answers(await openWebEdition(t, { to: '#program' }));

  assert.deepEqual(page, studio);
});
