import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

const WEB = '../../main/resources/org/robonewbie/studio/web/state/motion';
const { balanceOf } = await import(`${WEB}/balance.js`);
const { balancedPosture, balanceText, madeBalanced } = await import(`${WEB}/balancing.js`);
const { bodyOf, linkIndex, placed, pointOf, posesOf } = await import(`${WEB}/body.js`);
const { framesOf, initialEditor, selected, withFile, withUndo } = await import(`${WEB}/editor-state.js`);
const { parse } = await import(`${WEB}/motion-text.js`);
const { STANDING } = await import(`${WEB}/poses.js`);
const { postureFrom } = await import(`${WEB}/posture.js`);

const file = join(process.env.STUDIO_FRAME_FOLDER ?? '', 'robot.json');
const body = existsSync(file) ? bodyOf(JSON.parse(readFileSync(file, 'utf8'))) : undefined;
const stand = body ? postureFrom(body, STANDING) : [];

/** @param {string} name @param {() => void} check */
function withBody(name, check) {
  test(name, { skip: body ? false : 'run by Maven' }, check);
}

/** @param {Record<string, number>} turns degrees by joint @returns {number[]} */
function standingBut(turns) {
  return stand.map((/** @type {number} */ angle, /** @type {number} */ i) => angle + (turns[body.joints[i].name] ?? 0));
}

/** @param {readonly number[]} posture */
const posesIn = (posture) => posesOf(body, posture, placed(body, posture, 'soles'));
const marginOf = (/** @type {readonly number[]} */ posture) => balanceOf(body, posesIn(posture)).margin;

const LEANING = { LEFT_FOOT_PITCH: -21, RIGHT_FOOT_PITCH: -21 };
const ONE_LEG = { RIGHT_HIP_PITCH: 15, RIGHT_KNEE_PITCH: -30, RIGHT_FOOT_PITCH: 15 };

withBody('a robot that leans too far is shifted over its fixed feet', () => {
  for (const turns of [LEANING, ONE_LEG]) {
    const posture = standingBut(turns);
    assert.ok(marginOf(posture) < 0, `leans: ${marginOf(posture)}`);

    const { posture: balanced, when } = balancedPosture(body, posture, 'soles');

    assert.equal(when, 'now');
    assert.ok(marginOf(balanced) >= 0.009, String(marginOf(balanced)));
    const apart = (/** @type {readonly number[]} */ each) => {
      const poses = posesIn(each);
      const [left, right] = ['lfoot', 'rfoot'].map((name) => pointOf(poses, linkIndex(body, name), [0, 0, 0]));
      return Math.hypot(...left.map((/** @type {number} */ value, /** @type {number} */ i) => value - right[i]));
    };
    assert.ok(Math.abs(apart(balanced) - apart(posture)) < 0.009, 'feet slip');
    body.joints.forEach((/** @type {any} */ { name, minDegrees, maxDegrees }, /** @type {number} */ i) => {
      assert.ok(balanced[i] >= minDegrees && balanced[i] <= maxDegrees, name);
      assert.ok(balanced[i] === posture[i] || /HIP|KNEE|FOOT/.test(name), `${name} turned`);
    });
  }
});

withBody('a whole motion is balanced in one step, and failures are explained', () => {
  const crouching = postureFrom(body, { BOTH_HIP_PITCH: 100, BOTH_KNEE_PITCH: -20, BOTH_FOOT_PITCH: 75 });
  const lines = [stand, standingBut(LEANING), crouching].map((posture) => `500 ${posture.join(' ')}\n`);
  const before = withFile(initialEditor(body), { name: 'mine', version: 'v1', document: parse(lines.join('')) });

  const { state, report } = madeBalanced(before);

  assert.deepEqual([report.before, report.now, report.never.map(({ index }) => index)], [1, 1, [2]]);
  assert.match(
    report.never[0].reason,
    /(is at its limit|not long enough), still \d+\.\d cm short of balance|not on its feet/,
  );
  assert.equal(state.history.past.length, 1);
  assert.ok(marginOf(framesOf(state)[1].degrees) > 0);
  assert.deepEqual(framesOf(state)[2], framesOf(before)[2]);
  assert.deepEqual(framesOf(withUndo(state)), framesOf(before));
  assert.equal(
    balanceText(report),
    '1 keyframe shifted, 1 keyframe was already balanced, 1 keyframe cannot be balanced.',
  );
  const two = madeBalanced(selected(selected(before, 1), 2, true)).report;
  assert.deepEqual([two.before, two.now, two.never.length], [0, 1, 1]);
});
