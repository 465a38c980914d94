import assert from 'node:assert/strict';
import { test } from 'node:test';

const state = '../../main/resources/org/robonewbie/studio/web/state/program';
const { changedLines, lineDiff, nearChanges } = await import(`${state}/line-diff.js`);
const { ageText, MAX_VERSIONS, versionsFrom, withVersion } = await import(`${state}/versions.js`);

/** @param {...string} texts */
const saved = (...texts) => texts.map((text, time) => ({ time, text })).reduce(withVersion, []);

const textsOf = (versions) => versions.map(({ text }) => text);
const shown = (lines) => lines.map((line) => (line ? line.sign + line.text : '…'));

test('each different text is a version, and saving the same text again is none', () => {
  assert.deepEqual(textsOf(saved('a', 'b', 'b', 'a')), ['a', 'b', 'a']);
});

test('the oldest of more than twenty versions goes', () => {
  const many = saved(...Array.from({ length: 22 }, (_, i) => `${i}`));

  assert.equal(many.length, MAX_VERSIONS);
  assert.equal(many[0].text, '2');
});

test('a huge text is not kept, and takes no version away', () => {
  assert.deepEqual(textsOf(saved('a', 'x'.repeat(50_001), 'b')), ['a', 'b']);
});

test('damaged versions are left out', () => {
  assert.deepEqual(versionsFrom({}), []);
  assert.deepEqual(versionsFrom(null), []);
  assert.deepEqual(versionsFrom([null, 3, { time: 'x', text: 'a' }, { time: 1 }, { time: 1, text: 'good' }]), [
    { time: 1, text: 'good' },
  ]);
});

test('the age of a version is in words', () => {
  const now = 1_800_000_000_000;

  assert.equal(ageText(now - 59_000, now), 'just now');
  assert.equal(ageText(now + 5000, now), 'just now');
  assert.equal(ageText(now - 125_000, now), '2 minutes ago');
  assert.equal(ageText(now - 3_600_000, now), '1 hour ago');
  assert.equal(ageText(now - 3 * 86_400_000, now), '3 days ago');
  assert.equal(ageText(0, now), 'earlier');
});

test('a comparison shows removed, added and common lines', () => {
  const lines = lineDiff('a\nb\nc\nd', 'a\nx\nc\ny\nd');

  assert.deepEqual(shown(lines), [' a', '−b', '+x', ' c', '+y', ' d']);
  assert.equal(changedLines(lines), 2);
  assert.equal(changedLines(lineDiff('a\nb', 'a\nb')), 0);
  assert.deepEqual(shown(lineDiff('', 'a')), ['−', '+a']);
});

test('both texts can be read from any comparison', () => {
  let seed = 7;
  const random = (/** @type {number} */ below) => (seed = (seed * 1103515245 + 12345) % 2147483648) % below;
  const text = () => Array.from({ length: random(12) }, () => 'abc'[random(3)]).join('\n');
  for (let i = 0; i < 500; i += 1) {
    const [before, after] = [text(), text()];
    const lines = lineDiff(before, after);
    const without = (/** @type {string} */ sign) => textsOf(lines.filter((line) => line.sign !== sign)).join('\n');

    assert.equal(without('+'), before);
    assert.equal(without('−'), after);
  }
});

test('long different texts are compared in a moment', () => {
  const numbered = (/** @type {string} */ word) => Array.from({ length: 9000 }, (_, i) => `${word}${i}`).join('\n');

  assert.equal(changedLines(lineDiff(numbered('a'), numbered('b'))), 9000);
});

test('lines far from a change are left out', () => {
  const before = 'abcdefghijklmnop'.split('').join('\n');

  assert.deepEqual(shown(nearChanges(lineDiff(before, before.replace('h', 'H')))), [
    ...['…', ' e', ' f', ' g', '−h', '+H', ' i', ' j', ' k', '…'],
  ]);
});
