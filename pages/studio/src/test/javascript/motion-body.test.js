import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

const WEB = '../../main/resources/org/robonewbie/studio/web/state/motion';
const { balanceOf, hull } = await import(`${WEB}/balance.js`);
const { bodyOf, linkIndex, placed, pointOf, posesOf } = await import(`${WEB}/body.js`);
const { bodyMarks, jointMarks } = await import(`${WEB}/checks.js`);
const { judgeDisk } = await import(`${WEB}/disk.js`);
const { collisionsOf } = await import(`${WEB}/collisions.js`);
const { deleted, duplicated, mirroredMotion, pasted, copied, shifted, timed, turned } = await import(`${WEB}/edits.js`);
const {
  atTime,
  documentOf,
  framesOf,
  initialEditor,
  isUnsaved,
  played,
  posed,
  selected,
  withFile,
  withKeyframeHere,
  withRedo,
  withUndo,
} = await import(`${WEB}/editor-state.js`);
const { parse, textOf } = await import(`${WEB}/motion-text.js`);
const { STANDING, readPostures, templatePostures, withPosture } = await import(`${WEB}/poses.js`);
const { copiedSide, mirrored, mostTurned, postureFrom, symmetric } = await import(`${WEB}/posture.js`);
const { chainJoints, followed, ownJoints, pulled, torsoMoved } = await import(`${WEB}/reach.js`);

const file = join(process.env.STUDIO_FRAME_FOLDER ?? '', 'robot.json');
const body = existsSync(file) ? bodyOf(JSON.parse(readFileSync(file, 'utf8'))) : undefined;
const stand = body ? postureFrom(body, STANDING) : [];

/** @param {string} name @param {() => void} check */
function withBody(name, check) {
  test(name, { skip: body ? false : 'run by Maven' }, check);
}

/** @param {string} name */
const joint = (name) => body.joints.findIndex((/** @type {any} */ each) => each.name === name);

/** @param {number} frames */
function editorWith(frames) {
  const text = Array.from({ length: frames }, (_, i) => `${100 * (i + 1)} ${stand.join(' ')} // ${i}\n`).join('');
  return withFile(initialEditor(body), { name: 'mine', version: 'v1', document: parse(text) });
}

withBody('the template postures are within all ranges and free of collisions', () => {
  for (const { name, degrees } of templatePostures(body)) {
    degrees.forEach((/** @type {number} */ angle, /** @type {number} */ i) => {
      const { minDegrees, maxDegrees } = body.joints[i];
      assert.ok(angle >= minDegrees && angle <= maxDegrees, `${name}: ${body.joints[i].name} ${angle}`);
    });
    const pairs = collisionsOf(body, posesOf(body, degrees, placed(body, degrees, 'soles')));
    assert.deepEqual(
      pairs.map((/** @type {number[]} */ pair) => pair.map((link) => body.model.links[link].name)),
      [],
      name,
    );
  }
});

withBody('standing is balanced on both soles, and arms inside the torso are found', () => {
  const balance = balanceOf(body, posesOf(body, stand, placed(body, stand, 'soles')));
  assert.ok(balance.margin > 0.02, String(balance.margin));
  const crossed = stand
    .with(joint('LEFT_SHOULDER_YAW'), -1)
    .with(joint('LEFT_ARM_ROLL'), 0)
    .with(joint('LEFT_ARM_YAW'), -90)
    .with(joint('LEFT_SHOULDER_PITCH'), -60);
  assert.ok(collisionsOf(body, posesOf(body, crossed, placed(body, crossed, 'soles'))).length > 0);
});

withBody('a bent robot is placed on its soles', () => {
  const leaning = stand.with(joint('LEFT_HIP_PITCH'), 60).with(joint('RIGHT_HIP_PITCH'), 60);
  const poses = posesOf(body, leaning, placed(body, leaning, 'soles'));
  const sole = linkIndex(body, 'lfoot');
  const [heel, toe] = [-0.08, 0.08].map((y) => pointOf(poses, sole, [0, y, -0.01])[2]);
  assert.ok(Math.abs(heel) < 1e-6 && Math.abs(toe) < 1e-6);
});

withBody('a pulled hand is reached with the whole arm, and only the elbow turns with its own joints', () => {
  const torso = placed(body, stand, 'soles');
  const link = linkIndex(body, 'llowerarm');
  const end = stand.with(joint('LEFT_SHOULDER_PITCH'), 20).with(joint('LEFT_ARM_YAW'), -60);
  let reached = stand;
  let target = [0, 0, 0];
  for (let step = 1; step <= 12; step++) {
    const wanted = stand.map(
      (/** @type {number} */ angle, /** @type {number} */ i) => angle + (step / 12) * (end[i] - angle),
    );
    target = pointOf(posesOf(body, wanted, torso), link, [0, 0.05, 0]);
    reached = pulled(body, reached, torso, { link, local: [0, 0.05, 0], target, joints: chainJoints(body, link) });
    const there = pointOf(posesOf(body, reached, torso), link, [0, 0.05, 0]);
    assert.ok(
      Math.hypot(...there.map((/** @type {number} */ value, /** @type {number} */ i) => value - target[i])) < 0.002,
      `step ${step}`,
    );
  }
  const own = pulled(body, stand, torso, { link, local: [0, 0.05, 0], target, joints: ownJoints(body, link) });
  body.joints.forEach((/** @type {any} */ { name, minDegrees, maxDegrees }, /** @type {number} */ i) => {
    assert.ok(own[i] === stand[i] || /LEFT_ARM/.test(name), name);
    assert.ok(own[i] >= minDegrees && own[i] <= maxDegrees);
  });
});

withBody('a large pointer jump ends as near as many small moves', () => {
  const torso = placed(body, stand, 'soles');
  const link = linkIndex(body, 'llowerarm');
  const local = [0, 0.05, 0];
  const joints = chainJoints(body, link);
  const from = pointOf(posesOf(body, stand, torso), link, local);
  for (const way of [
    [0.3, 0.2, 0.3],
    [-0.5, -0.1, 0.4],
    [0.1, -0.6, 0],
    [0, 0.2, -0.9],
  ]) {
    const at = (/** @type {number} */ part) =>
      from.map((/** @type {number} */ value, /** @type {number} */ axis) => value + part * way[axis]);
    const strides = Math.min(25, Math.ceil(Math.hypot(...way) / 0.02));
    let slowly = stand;
    for (let step = 1; step <= strides; step++) {
      slowly = followed(body, slowly, torso, { link, local, target: at(step / strides), joints });
    }
    const atOnce = followed(body, stand, torso, { link, local, target: at(1), joints });
    const distance = (/** @type {number[]} */ posture) =>
      Math.hypot(
        ...pointOf(posesOf(body, posture, torso), link, local).map(
          (/** @type {number} */ value, /** @type {number} */ i) => value - at(1)[i],
        ),
      );
    assert.ok(distance(atOnce) < distance(slowly) + 0.03, `${way}: ${distance(atOnce)} instead of ${distance(slowly)}`);
    body.joints.forEach((/** @type {any} */ { minDegrees, maxDegrees }, /** @type {number} */ i) =>
      assert.ok(atOnce[i] >= minDegrees && atOnce[i] <= maxDegrees),
    );
  }
});

withBody('the feet stay in place while the torso moves down', () => {
  const torso = placed(body, stand, 'soles');
  const moved = torsoMoved(body, stand, torso, [0, 0, -0.05]);
  for (const name of ['lfoot', 'rfoot']) {
    const link = linkIndex(body, name);
    const [before, after] = [posesOf(body, stand, torso), posesOf(body, moved.posture, moved.torso)].map((poses) =>
      pointOf(poses, link, [0, 0.08, -0.01]),
    );
    assert.ok(
      Math.hypot(...before.map((/** @type {number} */ value, /** @type {number} */ i) => value - after[i])) < 0.004,
      name,
    );
  }
  assert.ok(moved.posture[joint('LEFT_KNEE_PITCH')] < stand[joint('LEFT_KNEE_PITCH')] - 10);
});

withBody('mirroring swaps the sides', () => {
  const waving = stand.with(joint('LEFT_SHOULDER_YAW'), 60).with(joint('NECK_YAW'), 20);
  const image = mirrored(body, waving);
  assert.equal(image[joint('RIGHT_SHOULDER_YAW')], -60);
  assert.equal(image[joint('NECK_YAW')], -20);
  assert.deepEqual(mirrored(body, image), waving);
  assert.equal(symmetric(body, stand, waving)[joint('RIGHT_SHOULDER_YAW')], -60);
  assert.equal(copiedSide(body, waving, 'LEFT')[joint('RIGHT_SHOULDER_YAW')], -60);
});

withBody('motor limits and collisions are marked with time and reason', () => {
  const frames = [
    { millis: 500, degrees: stand },
    { millis: 100, degrees: stand.with(joint('NECK_YAW'), 90) },
    { millis: 500, degrees: stand.with(joint('NECK_PITCH'), 60) },
  ];
  const marks = jointMarks(body, frames);
  assert.deepEqual(
    marks.map(({ kind, from, to }) => [kind, from, to]),
    [
      ['speed', 500, 600],
      ['range', 1100, 1100],
    ],
  );
  assert.match(marks[0].text, /neck yaw turns 90° in 100 ms; its motor needs 260 ms/);
  assert.deepEqual(bodyMarks(body, frames, 'soles'), []);
});

withBody('a posture at the playhead becomes a keyframe, in time', () => {
  const state = posed(atTime(editorWith(2), 200), stand.with(0, 10), 'Drag');
  assert.deepEqual(
    framesOf(state).map(({ millis }) => millis),
    [100, 100, 100],
  );
  assert.equal(framesOf(state)[1].degrees[0], 10);
  assert.equal(state.last, 1);
  assert.ok(isUnsaved(state));
  assert.ok(!isUnsaved(withUndo(withUndo(state))));
});

withBody('keyframes are duplicated, copied, moved, timed and deleted, each undone in one step', () => {
  const state = selected(selected(editorWith(3), 0), 1, true);
  const millisOf = (/** @type {any} */ each) => framesOf(each).map(({ millis }) => millis);
  assert.deepEqual(millisOf(duplicated(state)), [100, 200, 100, 200, 300]);
  assert.deepEqual(millisOf(pasted(selected(state, 2), copied(state))), [100, 200, 300, 100, 200]);
  assert.deepEqual(millisOf(shifted(state, 1)), [300, 100, 200]);
  assert.deepEqual(millisOf(shifted(shifted(state, 1), -1)), [100, 200, 300]);
  assert.deepEqual(millisOf(deleted(state)), [300]);
  assert.deepEqual(millisOf(timed(state, 2, 333)), [100, 200, 340]);
  for (const edit of [duplicated, deleted, mirroredMotion]) {
    assert.equal(textOf(documentOf(withUndo(edit(state)))), textOf(documentOf(state)));
  }
});

withBody('symmetric editing turns the partner too', () => {
  const state = turned({ ...editorWith(1), symmetric: true }, joint('LEFT_SHOULDER_YAW'), 45);
  assert.equal(framesOf(state)[0].degrees[joint('RIGHT_SHOULDER_YAW')], -45);
});

withBody('a new keyframe at the end comes after the last one', () => {
  const state = withKeyframeHere(selected(editorWith(2), 1));
  assert.deepEqual(
    framesOf(state).map(({ millis }) => millis),
    [100, 200, 500],
  );
});

withBody('the animation stops at the end or loops', () => {
  const state = { ...editorWith(2), playing: true };
  assert.equal(played({ ...state, time: 0 }, 150).time, 150);
  assert.deepEqual([played(state, 1000).playing, played(state, 1000).time], [false, 300]);
  assert.equal(played({ ...state, looping: true, time: 0 }, 450).time, 150);
});

withBody('changes on the disk are reloaded, asked about, or reported', () => {
  const state = editorWith(1);
  assert.equal(judgeDisk(state, [{ name: 'mine', version: 'v1' }]), 'same');
  assert.equal(judgeDisk(state, [{ name: 'mine', version: 'v2' }]), 'reload');
  assert.equal(judgeDisk(turned(state, 0, 5), [{ name: 'mine', version: 'v2' }]), 'ask');
  assert.equal(judgeDisk(state, []), 'gone');
});

withBody('the user’s postures are stored in a readable file', () => {
  const text = withPosture('', { name: 'Bow', degrees: stand });
  assert.match(text, /^\/\/ posture: Bow\n500 /);
  assert.deepEqual(readPostures(text), [{ name: 'Bow', degrees: stand }]);
});

withBody('another posture keeps all lines of the file, valid or not', () => {
  const [bow, other] = [stand, stand.map((each) => each + 1)];
  const mine = withPosture('# mine\r\n500 1 2 three\r\n\r\n', { name: 'Bow', degrees: bow });
  const before = `${mine}// the end`;

  const after = withPosture(before, { name: 'Nod', degrees: other });
  assert.equal(after.slice(0, before.length + 1), `${before}\n`);
  assert.deepEqual(
    readPostures(after).map(({ name }) => name),
    ['Bow', 'Nod'],
  );

  const again = withPosture(after, { name: 'Bow', degrees: other });
  assert.deepEqual(again.split('\n').length, after.split('\n').length);
  assert.deepEqual(readPostures(again), [
    { name: 'Bow', degrees: other },
    { name: 'Nod', degrees: other },
  ]);
});

test('the hull of a square with a point inside is the square', () => {
  assert.deepEqual(
    hull([
      [0, 0],
      [1, 0],
      [0.5, 0.5],
      [1, 1],
      [0, 1],
    ]),
    [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ],
  );
});

withBody('undo and redo select the keyframe that they change', () => {
  const changed = turned(selected(editorWith(4), 2), joint('NECK_YAW'), 20);

  assert.equal(withUndo(selected(changed, 0)).last, 2);
  assert.equal(withRedo(selected(withUndo(changed), 0)).last, 2);
});

withBody('an edit without effect adds no undo step', () => {
  const state = editorWith(2);

  assert.equal(turned(state, joint('LEFT_KNEE_PITCH'), stand[joint('LEFT_KNEE_PITCH')]).history.past.length, 0);
  assert.equal(timed(state, 1, framesOf(state)[1].millis).history.past.length, 0);
});

withBody('a dragged limb selects the joint that turns most', () => {
  const posture = stand.with(joint('LEFT_ARM_ROLL'), -70).with(joint('LEFT_ARM_YAW'), -30);

  assert.equal(mostTurned(stand, posture, 0), joint('LEFT_ARM_ROLL'));
  assert.equal(mostTurned(stand, stand, 7), 7);
});

withBody('the head is a sphere: an arm beside the corner of its bounding box does not touch it', () => {
  const near = stand
    .with(joint('NECK_YAW'), 33)
    .with(joint('NECK_PITCH'), 7)
    .with(joint('RIGHT_SHOULDER_PITCH'), -95.5);
  const poses = posesOf(body, near, placed(body, near, 'soles'));

  assert.deepEqual(collisionsOf(body, poses), []);
  const inside = poses.slice();
  const [hand, head] = ['rupperarm', 'head'].map((name) => 7 * linkIndex(body, name));
  inside.set(poses.slice(head, head + 3), hand);
  assert.ok(collisionsOf(body, inside).some((pair) => pair.includes(linkIndex(body, 'head'))));
});
