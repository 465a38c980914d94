import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

const WEB = '../../main/resources/org/robonewbie/studio/web/state/motion';
const { bodyOf, hingeDegrees, linkIndex, placed, posesOf } = await import(`${WEB}/body.js`);
const { collisionsOf } = await import(`${WEB}/collisions.js`);
const { faultsAt, lagFaults, linkOf } = await import(`${WEB}/faults.js`);
const { lagOf } = await import(`${WEB}/lag.js`);
const { STANDING } = await import(`${WEB}/poses.js`);
const { postureFrom } = await import(`${WEB}/posture.js`);
const { postureAt } = await import(`${WEB}/timing.js`);

const folder = process.env.STUDIO_FRAME_FOLDER ?? '';
const read = (/** @type {string} */ name) =>
  existsSync(join(folder, name)) ? JSON.parse(readFileSync(join(folder, name), 'utf8')) : undefined;
const robot = read('robot.json');
const touching = read('touching.json');
const body = robot && bodyOf(robot);
const stand = body ? postureFrom(body, STANDING) : [];

/** @param {string} name */
const joint = (name) => body.joints.findIndex((/** @type {any} */ each) => each.name === name);

/** @param {readonly number[]} posture */
const posesIn = (posture) => posesOf(body, posture, placed(body, posture, 'soles'));

/** @param {any[]} frames @param {number} time */
function faults(frames, time) {
  const posture = postureAt(frames, frames[0].degrees, time);
  return faultsAt(body, frames, time, posture, posesIn(posture));
}

test('collisions equal those of the simulator', { skip: touching ? false : 'run by Maven' }, () => {
  const [clearDepth, slightDepth] = [0.012, 0.001];
  let found = 0;
  for (const { degrees, pairs } of touching) {
    const poses = posesOf(body, degrees, [0, 0, 0, 1, 0, 0, 0]);
    const here = collisionsOf(body, poses).map(([a, b]) => `${a} ${b}`);
    const depths = new Map(pairs.map(([a, b, depth]) => [`${Math.min(a, b)} ${Math.max(a, b)}`, depth]));
    for (const pair of here) {
      assert.ok((depths.get(pair) ?? 0) > slightDepth, `${pair} touches only here, in ${degrees}`);
    }
    const judged = judgedPairs();
    for (const [pair, depth] of depths) {
      if (depth > clearDepth && judged.has(pair)) {
        assert.ok(here.includes(pair), `${pair} touches ${depth} m deep in the simulator, in ${degrees}`);
        found += 1;
      }
    }
  }
  assert.ok(found > 60, String(found));
});

/** Collision candidates, all moved to one position, so that all of them touch. */
function judgedPairs() {
  const poses = new Float64Array(7 * body.links.length);
  body.links.forEach((/** @type {unknown} */ _, /** @type {number} */ link) =>
    poses.set([0, 0, 0, 1, 0, 0, 0], 7 * link),
  );
  return new Set(collisionsOf(body, poses).map(([a, b]) => `${a} ${b}`));
}

test('speed, range and collision faults of a moment name their links', { skip: !body }, () => {
  const frames = [
    { millis: 500, degrees: stand },
    { millis: 100, degrees: stand.with(joint('NECK_YAW'), 90) },
    { millis: 400, degrees: stand.with(joint('LEFT_KNEE_PITCH'), -140) },
  ];

  assert.deepEqual(faults(frames, 200), []);
  const fast = faults(frames, 550);
  assert.deepEqual(
    fast.map(({ kind, links }) => [kind, links]),
    [['speed', [linkIndex(body, 'head')]]],
  );
  assert.match(fast[0].text, /^neck yaw would turn at 900°\/s, more than the 352°\/s that its motor can reach$/);
  const bent = faults(frames, 1000).filter(({ kind }) => kind === 'range');
  assert.equal(bent[0].text, 'left knee pitch at -140° is beyond -130° to 1°');
  assert.deepEqual(bent[0].links, [linkIndex(body, 'lshank')]);
  assert.equal(linkOf(body, joint('LEFT_SHOULDER_PITCH')), linkIndex(body, 'lupperarm'));
});

test('a slow transition names its fastest joint, and a joint at its limit is reported', { skip: !body }, () => {
  const frames = [
    { millis: 500, degrees: stand },
    { millis: 1000, degrees: stand.with(joint('RIGHT_HIP_PITCH'), 100) },
  ];

  const [fastest] = faults(frames, 600);
  assert.equal(fastest.text, 'fastest: right hip pitch at 65 of the 352°/s that its motor can reach');
  const limit = faults(frames, 1500).filter(({ kind }) => kind === 'limit');
  assert.deepEqual(
    limit.map(({ text }) => text),
    ['right hip pitch is at its limit, -25° to 100°'],
  );
});

test('the joint with the largest lag is named, with the time', { skip: !body }, () => {
  const knee = joint('LEFT_KNEE_PITCH');
  const plan = [{ millis: 200, degrees: stand.with(knee, stand[knee] - 40) }];
  const reached = [0, 0, -10, -20, -30, -40].map((turn) => stand.with(knee, stand[knee] + turn));
  const frames = reached.map((posture) => [0, 0, 0.35, 1, 0, 0, 0, ...hingeDegrees(body, posture)]);

  const lag = lagOf(body, plan, { frameSeconds: 0.04, frames });

  assert.equal(lag.joint, knee);
  assert.ok(
    Math.abs(lag.worst[knee].degrees - 8) < 1e-6 && lag.worst[knee].time === 40,
    JSON.stringify(lag.worst[knee]),
  );
  assert.deepEqual(lag.late[knee], [[40, 120]]);
  assert.ok(lag.worst.every(({ degrees }, i) => i === knee || degrees < 0.01));
  assert.deepEqual(
    lagFaults(body, lag, 45).map(({ text }) => text),
    ['left knee pitch is 8° off the plan'],
  );
  assert.deepEqual(lagFaults(body, lag, 200), []);
});
