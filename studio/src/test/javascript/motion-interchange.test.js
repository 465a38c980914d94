import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

const WEB = '../../main/resources/org/robonewbie/studio/web/state/motion';
const { bodyOf } = await import(`${WEB}/body.js`);
const { FORMATS, readMotion } = await import(`${WEB}/interchange.js`);
const { keyframesOf } = await import(`${WEB}/motion-document.js`);
const { parse, problemOf, textOf } = await import(`${WEB}/motion-text.js`);
const { STANDING } = await import(`${WEB}/poses.js`);
const { postureFrom } = await import(`${WEB}/posture.js`);
const { readWebots } = await import(`${WEB}/webots.js`);

const file = join(process.env.STUDIO_FRAME_FOLDER ?? '', 'robot.json');
const body = existsSync(file) ? bodyOf(JSON.parse(readFileSync(file, 'utf8'))) : undefined;
const stand = body ? postureFrom(body, STANDING) : [];

/** @param {string} name @param {() => void} check */
function withBody(name, check) {
  test(name, { skip: body ? false : 'run by Maven' }, check);
}

/** @param {string} name */
const joint = (name) => body.joints.findIndex((/** @type {any} */ each) => each.name === name);

/** @param {string} name @param {string} text */
const read = (name, text) => readMotion(name, new TextEncoder().encode(text), body, stand);

/** A motion that turns every joint by an amount of its own. */
function sample() {
  const turned = stand.map(
    (/** @type {number} */ angle, /** @type {number} */ i) => angle + (angle > 0 ? -1 : 1) * (i + 1) * 0.25,
  );
  return parse(`500 ${stand.join(' ')} // first\r\n1240 ${turned.join(' ')}\r\n`);
}

for (const format of FORMATS) {
  withBody(`a motion survives the way through ${format.id} and back`, () => {
    const before = keyframesOf(sample());

    const { document, notes } = read(`mine${format.ending}`, format.write(sample(), body, stand));

    const after = keyframesOf(document);
    assert.deepEqual(
      after.map(({ millis }) => millis),
      [500, 1240],
    );
    after.forEach(({ degrees }, i) =>
      degrees.forEach((angle, k) => assert.ok(Math.abs(angle - before[i].degrees[k]) < 1e-3, body.joints[k].name)),
    );
    assert.equal(problemOf(document), '');
    assert.ok(notes.every((note) => !note.includes('Not read')));
  });
}

withBody('NAO’s own signs are those of its documentation: bent knees and lowered arms are positive', () => {
  const webots = FORMATS.find(({ id }) => id === 'webots');
  const [head, row] = webots.write(parse(`500 ${stand.join(' ')}\n`), body, stand).split('\n');
  const value = (/** @type {string} */ name) => (Number(row.split(',')[head.split(',').indexOf(name)]) * 180) / Math.PI;

  assert.ok(Math.abs(value('LKneePitch') - 70) < 1e-3);
  assert.ok(Math.abs(value('RShoulderPitch') - 95) < 1e-3);
  assert.ok(Math.abs(value('LHipPitch') + 35) < 1e-3);
  assert.ok(Math.abs(value('LAnklePitch') + 37) < 1e-3);
  assert.ok(Math.abs(value('LElbowYaw') + 90) < 1e-3);
  assert.ok(Math.abs(value('LElbowRoll') + 40) < 1e-3);
  assert.ok(Math.abs(value('LShoulderRoll') - 10) < 1e-3);
});

withBody('the signs of a Webots file are told by what a robot can do', () => {
  const nao =
    '#WEBOTS_MOTION,V1.0,LKneePitch,HeadYaw{S},LHand\r\n00:00:120,Pose1,1.2,*,0\r\n00:01:120,Pose2,*,-1.5707963,0\r\n';
  const original = nao.replace('1.2', '-1.2');

  const first = read('theirs.motion', nao);
  const frames = keyframesOf(first.document);
  assert.deepEqual(
    frames.map(({ millis }) => millis),
    [120, 1000],
  );
  const knee = joint('LEFT_KNEE_PITCH');
  assert.ok(Math.abs(frames[1].degrees[knee] + 68.755) < 1e-3, 'a star keeps the angle');
  assert.equal(frames[0].degrees[0], stand[0]);
  assert.equal(frames[1].degrees[0], -90);
  assert.deepEqual(first.notes, [
    'Read with NAO’s own signs, as Webots writes them.',
    'Without LHand, which this robot does not have.',
  ]);
  const second = read('theirs.motion', original);
  assert.ok(Math.abs(keyframesOf(second.document)[0].degrees[knee] + 68.755) < 1e-3);
  assert.match(second.notes[0], /signs of the original motion editor/);
});

withBody('rows that cannot be read are kept with a message and their place', () => {
  const webots =
    '#WEBOTS_MOTION,V1.0,HeadYaw\n00:00:500,Pose1,0.1\n1,Pose2,0\n00:01:000,Pose3,x\n00:01:500,Pose4,0.2\n';
  const { document, notes } = read('theirs.motion', webots);

  assert.equal(keyframesOf(document).length, 2);
  assert.equal(document.lines[1].text, '1,Pose2,0');
  assert.equal(document.lines[2].text, '00:01:000,Pose3,x');
  assert.deepEqual(
    keyframesOf(document).map(({ millis }) => millis),
    [500, 1000],
  );
  assert.equal(
    notes[1],
    'Not read and kept as it is: line 3 of the file: found “1”, expected a time such as 00:01:500, and 1 more. Agents refuse the file until it is mended.',
  );
  const table = read('theirs.csv', 'way_ms,NECK_YAW\n500,10\nabc,20\n500,12a\n');
  assert.match(table.notes[0], /line 3 of the file: found “abc”, expected a time for way_ms, and 1 more/);
  assert.equal(table.document.lines[1].text, 'abc,20');
  const text = read('theirs.txt', `500 ${stand.join(' ')}\nnonsense\n`);
  assert.match(text.notes[0], /line 2 of the file: found “nonsense”, expected the time/);
  assert.match(textOf(text.document), /\nnonsense\n$/);
});

withBody('files that are no motions are refused in words', () => {
  assert.throws(() => readWebots('hello', body, stand), /no Webots motion/);
  assert.throws(() => read('theirs.mef', 'hello\n'), /first line is not “nao”/);
  assert.throws(() => read('theirs.csv', 'a,b\n1,2\n'), /must name a time \(way_ms, time_ms or time_s\) and joints/);
});

withBody('tables may have their own order, moments instead of ways, and decimal commas', () => {
  const head = '"time_s";Neck Pitch;LEFT KNEE PITCH;remark';
  const rows = ['# slowly', '0,5;12,5;-60;a', '1,5;;-70,25;b', ''];

  const { document, notes } = read('theirs.csv', [head, ...rows].join('\n'));

  const frames = keyframesOf(document);
  assert.deepEqual(
    frames.map(({ millis, degrees }) => [millis, degrees[1], degrees[joint('LEFT_KNEE_PITCH')]]),
    [
      [500, 12.5, -60],
      [1000, 12.5, -70.25],
    ],
  );
  assert.equal(frames[0].degrees[joint('RIGHT_KNEE_PITCH')], stand[joint('RIGHT_KNEE_PITCH')]);
  assert.equal(document.lines[0].text, '// slowly');
  assert.deepEqual(notes, ['Columns that are no joints were left out: remark.']);
});

withBody('of a net the way along the first transitions is taken, and other branches are kept as comments', () => {
  const net = [
    'nao',
    '# drawn by hand',
    'HeadYaw;HeadPitch;',
    'keyframe;0;100;100;1;2',
    'keyframe;1;200;100;10;20',
    'keyframe;2;300;100;30;40',
    'keyframe;3;300;200;50',
    'transition;0;1;500;*',
    'transition;0;2;700;fallen',
    'transition;1;2;1000;*',
    'transition;2;1;1000;*',
  ];

  const { document, notes } = read('theirs.mef', net.join('\r\n'));

  assert.deepEqual(
    keyframesOf(document).map(({ millis, degrees }) => [millis, degrees[0], degrees[1]]),
    [
      [500, 10, 20],
      [1000, 30, 40],
    ],
  );
  assert.deepEqual(
    document.lines.flatMap(({ text, keyframe }) => (keyframe ? [] : [text])),
    [
      'keyframe;3;300;200;50',
      '// another branch: transition;0;2;700;fallen',
      '// another branch: transition;2;1;1000;*',
    ],
  );
  assert.match(notes[0], /2 other transitions are kept as comments/);
  assert.match(notes[1], /goes on at keyframe 1 again; the motion ends there/);
  assert.match(notes[2], /line 7 of the file: found 1 angles, expected 2/);
});
