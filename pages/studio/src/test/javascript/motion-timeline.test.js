import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

const WEB = '../../main/resources/org/robonewbie/studio/web/state/motion';
const { bodyOf } = await import(`${WEB}/body.js`);
const { copied, deleted, moved, pasted, turnedBy } = await import(`${WEB}/edits.js`);
const { documentOf, framesOf, initialEditor, selected, withFile, withUndo } = await import(`${WEB}/editor-state.js`);
const { atMark, nextMark } = await import(`${WEB}/marks.js`);
const { parse, textOf } = await import(`${WEB}/motion-text.js`);
const { jointRows } = await import(`${WEB}/names.js`);
const { STANDING } = await import(`${WEB}/poses.js`);
const { postureFrom } = await import(`${WEB}/posture.js`);
const { retimed } = await import(`${WEB}/retime.js`);
const { boxed, toggled, withAllChosen, withOneChosen, withRow } = await import(`${WEB}/selection.js`);
const { revealing, scrolled, shownPart, WHOLE, zoomed } = await import(`${WEB}/time-view.js`);

const file = join(process.env.STUDIO_FRAME_FOLDER ?? '', 'robot.json');
const body = existsSync(file) ? bodyOf(JSON.parse(readFileSync(file, 'utf8'))) : undefined;
const stand = body ? postureFrom(body, STANDING) : [];

/** @param {string} name @param {() => void} check */
function withBody(name, check) {
  test(name, { skip: body ? false : 'run by Maven' }, check);
}

/** @param {string} name */
const joint = (name) => body.joints.findIndex((/** @type {any} */ each) => each.name === name);

/** Keyframes at 100, 300, 600 and 1000 ms, whose neck yaw is 0, 10, 20 and 30. */
function editor() {
  const lines = [0, 1, 2, 3].map((i) => `${100 * (i + 1)} ${stand.with(0, 10 * i).join(' ')} // ${i}\n`);
  return withFile(initialEditor(body), { name: 'mine', version: 'v1', document: parse(lines.join('')) });
}

const millis = (/** @type {any} */ state) => framesOf(state).map((/** @type {any} */ frame) => frame.millis);
const yaws = (/** @type {any} */ state) => framesOf(state).map((/** @type {any} */ frame) => frame.degrees[0]);

test('a moved keyframe shifts those after it, or moves alone without overtaking', () => {
  const ways = [100, 200, 300, 400];

  assert.deepEqual(retimed(ways, [1], 100, false), [100, 300, 300, 400]);
  assert.deepEqual(retimed(ways, [1], 100, true), [100, 300, 200, 400]);
  assert.deepEqual(retimed(ways, [1], 1000, true), [100, 480, 20, 400]);
  assert.deepEqual(retimed(ways, [1], -1000, true), [100, 20, 480, 400]);
  assert.deepEqual(retimed(ways, [3], 55, true), [100, 200, 300, 460]);
  assert.deepEqual(retimed(ways, [1], -1000, false), [100, 20, 300, 400]);
});

test('several keyframes that move alone keep their distances, even with others in between', () => {
  const ways = [100, 200, 300, 400];

  assert.deepEqual(retimed(ways, [1, 2], 100, true), [100, 300, 300, 300]);
  assert.deepEqual(retimed(ways, [0, 2], 60, true), [160, 140, 360, 340]);
  assert.deepEqual(retimed(ways, [0, 2], -500, true), [20, 280, 220, 480]);
});

test('the timeline shows the whole motion until it is zoomed, and never scrolls beyond it', () => {
  assert.deepEqual(shownPart(WHOLE, 2000), { from: 0, span: 2000 });
  const near = zoomed(WHOLE, 2000, 0.5, 1500);
  assert.deepEqual(near, { from: 750, span: 1000 });
  assert.equal(zoomed(near, 2000, 4, 0), WHOLE);
  assert.deepEqual(scrolled(near, 2000, 10), { from: 1000, span: 1000 });
  assert.deepEqual(scrolled(near, 2000, -10), { from: 0, span: 1000 });
  assert.equal(zoomed(WHOLE, 2000, 1e-9, 0).span, 200);
  assert.deepEqual(revealing(near, 2000, 1800), { from: 900, span: 1000 });
  assert.equal(revealing(near, 2000, 800), near);
});

withBody('the selected keyframes move in one undo step and keep their comments', () => {
  const state = selected(selected(editor(), 1), 2, true);

  const later = moved(state, 60, { alone: true });

  assert.deepEqual(millis(later), [100, 260, 300, 340]);
  assert.equal(later.time, 660);
  assert.deepEqual(later.chosen, [1, 2]);
  assert.match(textOf(documentOf(later)), /\/\/ 3\n$/);
  assert.equal(textOf(documentOf(withUndo(later))), textOf(documentOf(state)));
});

withBody('one drag is one undo step relative to its start', () => {
  const state = selected(editor(), 1);
  const base = documentOf(state);

  const dragged = [20, 40, 80].reduce((each, by) => moved(each, by, { base, gesture: 'drag 1' }), state);

  assert.deepEqual(millis(dragged), [100, 280, 300, 400]);
  assert.equal(dragged.history.past.length, 1);
});

withBody('an angle changes by the same amount in all selected keyframes within their ranges', () => {
  const state = withRow(toggled(selected(editor(), 1), 3), 0);

  assert.deepEqual(yaws(turnedBy(state, [0], 5)), [0, 15, 20, 35]);
  assert.deepEqual(yaws(turnedBy(state, [0], 200)), [0, 100, 20, 120]);
  assert.equal(turnedBy(state, [0], 5).history.past.length, 1);
});

withBody('symmetric editing mirrors the rotation of the partner', () => {
  const [left, right] = ['LEFT_SHOULDER_YAW', 'RIGHT_SHOULDER_YAW'].map(joint);

  const turned = framesOf(turnedBy({ ...editor(), symmetric: true }, [left], 20))[0].degrees;

  assert.equal(turned[left], stand[left] + 20);
  assert.equal(turned[right], stand[right] - 20);
});

withBody('a box selects keyframes and joints, on curves by their angles', () => {
  const rows = jointRows(body).slice(0, 2);

  const box = boxed(editor(), { from: 250, to: 700, rows });
  assert.deepEqual([box.chosen, box.rows, box.last], [[1, 2], rows, 2]);
  assert.deepEqual(boxed(selected(editor(), 3), { from: 250, to: 700, rows }, true).chosen, [3, 1, 2]);
  assert.deepEqual(boxed(editor(), { from: 0, to: 9999, low: 15, high: 90 }).chosen, [2, 3]);
  const none = editor();
  assert.equal(boxed(none, { from: 310, to: 320, rows }), none);
  assert.deepEqual(withOneChosen(withAllChosen(box)).chosen, [2]);
  assert.deepEqual(withAllChosen(box).chosen, [0, 1, 2, 3]);
});

withBody('non-adjacent keyframes are deleted and copied together', () => {
  const state = toggled(selected(editor(), 0), 2);

  assert.deepEqual(yaws(deleted(state)), [10, 30]);
  assert.deepEqual(yaws(pasted(selected(editor(), 3), copied(state))), [0, 10, 20, 30, 0, 20]);
});

withBody('for selected joints only the angles are copied, pasted and removed', () => {
  const state = withRow(selected(editor(), 2), 0);
  const clip = copied(state);

  assert.deepEqual(yaws(pasted(selected(editor(), 0), clip)), [20, 10, 20, 30]);
  assert.equal(framesOf(pasted(selected(editor(), 0), clip)).length, 4);
  const bent = turnedBy(state, [0], 50);
  assert.deepEqual(yaws(bent), [0, 10, 70, 30]);
  const [before, between, after] = [300, 600, 1000];
  const even = 10 + (20 * (between - before)) / (after - before);
  assert.ok(Math.abs(yaws(deleted(bent))[2] - even) < 1e-3);
  assert.equal(framesOf(deleted(bent)).length, 4);
});

withBody('marks are visited one after the other, and each shows its joint', () => {
  const speed = { kind: 'speed', from: 300, to: 600, text: '', joint: 5 };
  const range = { kind: 'range', from: 1000, to: 1000, text: '', joint: 7 };

  assert.equal(nextMark([range, speed], 0), speed);
  assert.equal(nextMark([range, speed], 450), range);
  assert.equal(nextMark([range, speed], 1000), speed);
  assert.equal(nextMark([], 0), undefined);
  assert.deepEqual([atMark(editor(), speed).time, atMark(editor(), speed).joint], [450, 5]);
  assert.deepEqual([atMark(editor(), range).last, atMark(editor(), range).joint], [3, 7]);
});
