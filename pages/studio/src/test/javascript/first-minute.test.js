import assert from 'node:assert/strict';
import test from 'node:test';
import { ghostOf, nextLevel } from '../../main/resources/org/robonewbie/studio/web/state/program/first-minute.js';

/** @typedef {import('../../main/resources/org/robonewbie/studio/web/state/program/first-minute.js').Level} Level */

/** @param {Partial<Level>} rest @returns {Level} */
const level = (rest) => ({
  name: 'wave',
  title: 'Wave',
  goal: '',
  file: 'Wave.java',
  passed: false,
  start: '',
  solution: '',
  ...rest,
});

const WAVE = level({ start: 'a\n  raise(0); // up\nb', solution: 'a\n  raise(90); // up\nb' });
const KICK = level({ file: 'Kick.java', start: 'a\n\n\n}', solution: 'a\n  walk();\n  kick();\n}' });

/** Inserts the ghost text as Tab does. @param {string} text @param {Level} of */
function withGhost(text, of) {
  const ghost = ghostOf(text, of);
  assert.ok(ghost);
  return text.slice(0, ghost.from) + ghost.insert + text.slice(ghost.to);
}

test('ghost text changes a number', () => {
  const ghost = ghostOf(WAVE.start, WAVE);

  assert.equal(WAVE.start.slice(ghost?.from, ghost?.to), '0');
  assert.equal(ghost?.insert, '90');
  assert.equal(withGhost(WAVE.start, WAVE), WAVE.solution);
  assert.equal(ghostOf(WAVE.solution, WAVE), undefined);
});

test('there is no ghost text when the newcomer has chosen another number', () => {
  assert.equal(ghostOf(WAVE.start.replace('0', '85'), WAVE), undefined);
  assert.equal(ghostOf('', WAVE), undefined);
});

test('ghost text follows wherever the line has moved', () => {
  assert.equal(withGhost(`\n\n  ${WAVE.start}`, WAVE), `\n\n  ${WAVE.solution}`);
  assert.equal(withGhost('a\n      raise(0); // up\nb', WAVE), 'a\n      raise(90); // up\nb');
});

test('lines are proposed one after the other, and completed while they are typed', () => {
  const first = withGhost(KICK.start, KICK);

  assert.equal(first, 'a\n  walk();\n\n}');
  assert.equal(withGhost(first, KICK), KICK.solution);
  assert.equal(withGhost('a\n  wal\n\n}', KICK), first);
  assert.equal(ghostOf('a\n  turn();\n\n}', KICK), undefined);
  assert.equal(ghostOf('a\n  walk();\n}', KICK), undefined);
});

const LESSON = { standing: { tries: 0 } };
const PROGRAMS = { open: true, own: [], drafts: [] };

/** @param {Level[]} levels @param {object[]} lessons */
const course = (levels, lessons = [LESSON]) =>
  /** @type {any} */ ({ language: 'en', lessons, firstMinute: { levels, words: {} } });

test('a newcomer gets the first level that is not passed', () => {
  assert.equal(nextLevel(course([WAVE, KICK]), PROGRAMS), WAVE);
  assert.equal(nextLevel(course([level({ passed: true }), KICK]), { ...PROGRAMS, own: [{ path: 'Wave.java' }] }), KICK);
  assert.equal(nextLevel(course([level({ passed: true })]), PROGRAMS), undefined);
});

test('a returning user gets none', () => {
  assert.equal(nextLevel(course([WAVE], [{ standing: { tries: 1 } }]), PROGRAMS), undefined);
  assert.equal(nextLevel(course([WAVE]), { ...PROGRAMS, own: [{ path: 'MyAgent.java' }] }), undefined);
  assert.equal(nextLevel(course([WAVE]), { ...PROGRAMS, drafts: [{ path: 'MyAgent.java' }] }), undefined);
});

test('the studio of a running program has no levels', () => {
  const programs = { ...PROGRAMS, first: { path: 'MyDance.java', example: 'Agent_Dance' } };

  assert.equal(nextLevel(course([WAVE]), programs), undefined);
});

test('a studio without programs or without exercises has no levels', () => {
  assert.equal(nextLevel(course([WAVE]), { ...PROGRAMS, open: false }), undefined);
  assert.equal(nextLevel(/** @type {any} */ ({ lessons: [] }), PROGRAMS), undefined);
});
