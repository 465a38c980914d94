import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';

const WEB = '../../main/resources/org/robonewbie/studio/web/state/motion';
const { bodyOf } = await import(`${WEB}/body.js`);
const { FORMATS, readMotion } = await import(`${WEB}/interchange.js`);
const { keyframesOf } = await import(`${WEB}/motion-document.js`);
const { encode, parse, problemOf, textOf } = await import(`${WEB}/motion-text.js`);
const { asOriginal, hasSkippedKeyframes, isUndescribed } = await import(`${WEB}/original-rule.js`);
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

/** A motion that turns every joint by a different amount. */
function sample() {
  const turned = stand.map(
    (/** @type {number} */ angle, /** @type {number} */ i) => angle + (angle > 0 ? -1 : 1) * (i + 1) * 0.25,
  );
  return parse(`500 ${stand.join(' ')} // first\r\n1240 ${turned.join(' ')}\r\n`);
}

for (const format of FORMATS) {
  withBody(`a motion survives the round trip through ${format.id} and back`, () => {
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

withBody('NAO’s sign conventions are those of its documentation: bent knees and lowered arms are positive', () => {
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

withBody('the sign convention of a Webots file is detected by the joint ranges', () => {
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
    'Angles were read with NAO’s sign conventions, as Webots writes them.',
    'Skipped LHand, which this robot does not have.',
    'No column for NECK_PITCH, LEFT_SHOULDER_PITCH, LEFT_SHOULDER_YAW and 17 more joints: the angles of the start posture are used.',
  ]);
  const second = read('theirs.motion', original);
  assert.ok(Math.abs(keyframesOf(second.document)[0].degrees[knee] + 68.755) < 1e-3);
  assert.match(second.notes[0], /sign conventions of the original motion editor/);
});

withBody('unreadable rows are kept with a message and their line number', () => {
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
    notes[2],
    'Skipped and kept unchanged: line 3 of the file: found “1”, expected a time such as 00:01:500, and 1 more. Agents reject the file until it is corrected.',
  );
  const table = read('theirs.csv', 'way_ms,NECK_YAW\n500,10\nabc,20\n500,12a\n');
  assert.match(table.notes[1], /line 3 of the file: found “abc”, expected a time for way_ms, and 1 more/);
  assert.equal(table.document.lines[1].text, 'abc,20');
  const text = read('theirs.txt', `500 ${stand.join(' ')}\nnonsense\n`);
  assert.match(text.notes[0], /line 2 of the file: found “nonsense”, expected the time/);
  assert.match(textOf(text.document), /\nnonsense\n$/);
});

withBody('files that are not motions are refused with a message', () => {
  assert.throws(() => readWebots('hello', body, stand), /not a Webots motion/);
  assert.throws(() => read('theirs.mef', 'hello\n'), /first line is not “nao”/);
  assert.throws(() => read('theirs.csv', 'a,b\n1,2\n'), /must name a time \(way_ms, time_ms or time_s\) and joints/);
});

withBody('tables may have any column order, times instead of durations, and decimal commas', () => {
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
  assert.deepEqual(notes, [
    'Skipped remark, which this robot does not have.',
    'No column for NECK_YAW, LEFT_SHOULDER_PITCH, LEFT_SHOULDER_YAW and 17 more joints: the angles of the start posture are used.',
    'Where a cell is empty (line 4), the joint keeps its angle.',
  ]);
});

withBody('the path along the first transitions of a net is imported, and other branches are kept as comments', () => {
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
  assert.match(notes[1], /2 other transitions are kept as comments/);
  assert.match(notes[2], /returns to keyframe 1; the motion ends there/);
  assert.match(notes[3], /line 7 of the file: found 1 angles, expected 2/);
});

/** @param {any} document @param {string} name @returns {Array<[number, number]>} duration and angle of each keyframe */
const played = (document, name) =>
  keyframesOf(document).map(({ millis, degrees }) => [millis, Math.round(10 * degrees[joint(name)]) / 10]);

const HEAD = '#WEBOTS_MOTION,V1.0,LShoulderPitch,RShoulderPitch';

/** @type {Array<[what: string, file: string, text: string, frames: Array<[number, number]>, note: RegExp]>} */
const READ = [
  [
    'names in the second line',
    'a.motion',
    '#WEBOTS_MOTION,V1.0\nLShoulderPitch,RShoulderPitch\n00:00:400,Pose1,1.2,1.2\n00:00:800,Pose2,-0.3,-0.3\n',
    [
      [400, -68.8],
      [400, 17.2],
    ],
    /NAO’s sign conventions/,
  ],
  [
    'names in the second line, and a head that ends with a comma',
    'a.motion',
    '#WEBOTS_MOTION,V1.0,\r\n\r\nLShoulderPitch,RShoulderPitch,\r\n00:00:400,Pose1,1.2,1.2,\r\n',
    [[400, -68.8]],
    /NAO’s sign conventions/,
  ],
  [
    'the form of version 1.1',
    'a.motion',
    '#WEBOTS_MOTION,V1.1\nHeadYaw%LShoulderPitch\nplay%0%1.2%0.1\nplay%0.1%-0.3%0.500',
    [
      [100, -68.8],
      [500, 17.2],
    ],
    /duration in seconds/,
  ],
  [
    'a row with more values than names',
    'a.motion',
    `${HEAD}\n00:00:400,Pose1,1.2,1.2,0.5\n00:00:800,Pose2,-0.3,-0.3\n`,
    [[800, 17.2]],
    /line 2 of the file: found 3 angles, expected 2/,
  ],
  [
    'a row with a decimal comma',
    'a.motion',
    `${HEAD}\n00:00:400,Pose1,1,2,1,2\n00:00:800,Pose2,-0.3,-0.3\n`,
    [[800, 17.2]],
    /line 2 of the file: found 4 angles, expected 2/,
  ],
  [
    'a row with fewer values',
    'a.motion',
    `${HEAD}\n00:00:400,Pose1,1.2,1.2\n00:00:800,Pose2,-0.3\n`,
    [[400, -68.8]],
    /line 3 of the file: found 1 angles, expected 2/,
  ],
  [
    'a row of version 1.1 without its time',
    'a.motion',
    '#WEBOTS_MOTION,V1.1\nHeadYaw%LShoulderPitch\nplay%0%1.2\nplay%0.1%-0.3%0.500',
    [[500, 17.2]],
    /line 3 of the file: found 1 angles, expected 2/,
  ],
  [
    'an empty cell',
    'a.motion',
    `${HEAD}\n00:00:400,Pose1,1.2,1.2\n00:00:800,Pose2,,-0.3\n`,
    [
      [400, -68.8],
      [400, -68.8],
    ],
    /Where a cell is empty \(line 3\), the joint keeps its angle/,
  ],
  [
    'times that decrease or repeat',
    'a.motion',
    `${HEAD}\n00:00:400,Pose1,1.2,1.2\n00:00:300,Pose2,0,0\n00:00:400,Pose2,0,0\n00:01:000,Pose3,-0.3,0\n`,
    [
      [400, -68.8],
      [600, 17.2],
    ],
    /line 3 of the file: found the time 300 ms, expected a time later than the previous one, 400 ms, and 1 more/,
  ],
  [
    'times closer than a cycle',
    'a.motion',
    `${HEAD}\n00:00:000,Pose1,1.2,1.2\n00:00:010,Pose2,1.2,0\n00:00:100,Pose2,-0.3,0\n`,
    [
      [20, -68.8],
      [20, -68.8],
      [60, 17.2],
    ],
    /shorter than one cycle of 20 ms are extended to 20 ms \(line 3\)/,
  ],
  [
    'invalid numbers',
    'a.motion',
    `${HEAD}\n00:00:400,P,NaN,0\n00:00:500,P,Infinity,0\n00:00:600,P,0x10,0\n00:00:700,P,1e999,0\n00:00:800,P,1.2,0`,
    [[800, -68.8]],
    /line 2 of the file: found “NaN”, expected an angle in radians, such as -0.35, and 3 more/,
  ],
  [
    'a table with NAO’s names',
    'a.csv',
    'time_s,LShoulderPitch\n0.5,68.8\n1.5,-17.2\n',
    [
      [500, -68.8],
      [1000, 17.2],
    ],
    /NAO’s joint names: angles were read as degrees with NAO’s sign conventions/,
  ],
  [
    'a table with more cells than names',
    'a.csv',
    'way_ms,LEFT_SHOULDER_PITCH\n500,10,20\n500,40\n',
    [[500, 40]],
    /line 2 of the file: found 2 angles, expected 1/,
  ],
  [
    'a table with separators behind its cells, and empty rows',
    'a.csv',
    'way_ms,LEFT_SHOULDER_PITCH,,\n500,10,,\n,,,\n700,30,,\n',
    [
      [500, 10],
      [700, 30],
    ],
    /No column for/,
  ],
  [
    'a table with numbers in quotes',
    'a.csv',
    '"way_ms","LEFT_SHOULDER_PITCH","RIGHT_SHOULDER_PITCH"\n"500","10,5","20,5"\n',
    [[500, 10.5]],
    /No column for/,
  ],
  [
    'a table with Excel’s separator hint',
    'a.csv',
    'sep=;\r\n# slowly\r\nway_ms;LEFT_SHOULDER_PITCH\r\n500;10,5\r\n',
    [[500, 10.5]],
    /No column for/,
  ],
  [
    'a table that Excel saves as text',
    'a.txt',
    'way_ms\tLEFT_SHOULDER_PITCH\r\n500\t10,5\r\n',
    [[500, 10.5]],
    /No column for/,
  ],
  [
    'invalid times',
    'a.csv',
    'way_ms,LEFT_SHOULDER_PITCH\n0,10\n-5,20\n500,30\n',
    [[500, 30]],
    /line 2 of the file: found “0”, expected a time above 0, and 1 more/,
  ],
  [
    'thousands with a dot',
    'a.csv',
    'way_ms;LEFT_SHOULDER_PITCH\n1.000,0;10\n500;30\n',
    [[500, 30]],
    /line 2 of the file: found “1.000,0”, expected a time for way_ms/,
  ],
  [
    'a net with a duplicate keyframe and a dangling transition',
    'a.mef',
    'nao\nLShoulderPitch;\nkeyframe;0;0;0;0\nkeyframe;1;0;0;10\nkeyframe;1;0;0;99\ntransition;0;1;500;*\ntransition;1;7;500;*\n',
    [[500, 10]],
    /line 5 of the file: found keyframe 1, which is already defined, and 1 more/,
  ],
];

for (const [what, name, text, frames, note] of READ) {
  withBody(`an import notes with its line: ${what}`, () => {
    const { document, notes } = read(name, text);

    assert.deepEqual(played(document, 'LEFT_SHOULDER_PITCH'), frames);
    assert.match(notes.join('\n'), note);
  });
}

/** @type {Array<[what: string, file: string, text: string, message: RegExp]>} */
const REFUSED = [
  [
    'no names at all',
    'a.motion',
    '#WEBOTS_MOTION,V1.0\n00:00:400,Pose1,1.2\n',
    /names no joints, neither in its first/,
  ],
  ['nothing below the head', 'a.motion', '#WEBOTS_MOTION,V1.1\n', /names no joints/],
  ['only names', 'a.motion', HEAD, /a.motion was not imported: it has no keyframe/],
  [
    'only unknown joints',
    'a.motion',
    '#WEBOTS_MOTION,V1.0,l_knee,r_knee\n00:01:000,P,1,1\n',
    /line 1 names no joint of this robot: found “l_knee”, “r_knee”/,
  ],
  [
    'semicolons',
    'a.motion',
    '#WEBOTS_MOTION,V1.0,LKneePitch;RKneePitch\n00:01:000;P;1,2;1,0\n',
    /line 1 names no joint of this robot: found “LKneePitch;RKneePitch”/,
  ],
  [
    'a joint twice',
    'a.motion',
    '#WEBOTS_MOTION,V1.0,LKneePitch,LKneePitch\n00:01:000,P,1,-1\n',
    /line 1 names “LKneePitch” twice/,
  ],
  [
    'a column without a name',
    'a.motion',
    '#WEBOTS_MOTION,V1.0,LKneePitch,,HeadYaw\n00:01:000,P,1,-1,0\n',
    /line 1 has no name for its angle column 2/,
  ],
  [
    'seconds',
    'a.motion',
    `${HEAD}\n0.5,P,1.2,0\n1.0,P,0.1,0\n`,
    /no keyframe can be read. Line 2 of the file: found “0.5”, expected a time such as 00:01:500/,
  ],
  [
    'another version',
    'a.motion',
    '#WEBOTS_MOTION,V3.0,LKneePitch\n00:01:000,P,1\n',
    /has version “V3.0”; only V1.0 and V1.1 can be read/,
  ],
  [
    'a table of unknown joints',
    'a.csv',
    'time_s,lshoulderpitch_typo\n0.5,1.0\n',
    /line 1 names no joint of this robot: found “lshoulderpitch_typo”/,
  ],
  ['a table without a time', 'a.csv', 'LEFT_KNEE_PITCH\n-60\n', /must name a time/],
  [
    'a table with one joint by two names',
    'a.csv',
    'way_ms,LKneePitch,LEFT_KNEE_PITCH\n500,60,-60\n',
    /names one joint twice, as “LKneePitch” and “LEFT_KNEE_PITCH”/,
  ],
  ['an empty table', 'a.csv', '', /must name a time/],
  ['a table without rows', 'a.csv', 'way_ms,LEFT_KNEE_PITCH\n# nothing\n', /has no keyframe/],
  ['a net with a joint twice', 'a.mef', 'nao\nHeadYaw;HeadYaw;\nkeyframe;0;0;0;1;2\n', /names “HeadYaw” twice/],
  ['a net without a way', 'a.mef', 'nao\nHeadYaw;\nkeyframe;0;0;0;1\n', /has no keyframe/],
  ['three numbers', 'a.txt', '500 0 0\n', /no keyframe can be read. Line 1 of the file: 2 angles, expected 22/],
  ['comments only', 'a.txt', '// later\n', /has no keyframe/],
  ['nothing', 'a.txt', '', /has no keyframe/],
  [
    'a project of Choregraphe',
    'a.xar',
    '<?xml version="1.0"?>\n<Project/>\n',
    /imports .motion, .mef, .txt, .csv, .tsv/,
  ],
];

for (const [what, name, text, message] of REFUSED) {
  withBody(`an import is refused: ${what}`, () => {
    assert.throws(() => read(name, text), message);
  });
}

withBody('an import reads what editors and spreadsheets save', () => {
  const table = 'way_ms;LEFT_SHOULDER_PITCH;für mich\r\n500;10,5;\r\n';
  const wide = Buffer.from(`\uFEFF${table}`, 'utf16le');

  for (const bytes of [Buffer.from(table), Buffer.from(`\uFEFF${table}`), wide, Buffer.from(table, 'latin1')]) {
    const { document, notes } = readMotion('mine.csv', new Uint8Array(bytes), body, stand);
    assert.deepEqual(played(document, 'LEFT_SHOULDER_PITCH'), [[500, 10.5]]);
    assert.match(notes[0], /Skipped für mich/);
  }
  const damaged = Uint8Array.from([...Buffer.from(`${table}# ä\n`), 0xff]);
  assert.throws(() => readMotion('mine.csv', damaged, body, stand), /mine.csv was not imported: line 4 is not UTF-8/);
});

withBody('an old motion in Windows-1252 keeps its encoding', () => {
  const bytes = new Uint8Array(Buffer.from(`// für Zoë\r\n500 ${stand.join(' ')}\r\n`, 'latin1'));

  const { document, notes } = readMotion('old.txt', bytes, body, stand);

  assert.deepEqual(encode(document), bytes);
  assert.match(notes[0], /^In line 1 is not UTF-8|line 1 is not UTF-8 and was read as Windows-1252/);
});

withBody('a motion with zero durations survives the round trip through other formats', () => {
  for (const format of FORMATS.filter(({ id }) => id !== 'original-text')) {
    const given = format.write(parse(`500 ${stand.join(' ')}\n0 ${stand.map(() => 1).join(' ')}\n`), body, stand);
    const { document, notes } = read(`mine${format.ending}`, given);
    assert.deepEqual(
      keyframesOf(document).map(({ millis }) => millis),
      [500, 20],
      format.id,
    );
    assert.ok(notes.every((note) => !note.includes('Not read')));
  }
});

const POSE = (/** @type {number} */ millis, /** @type {number} */ angle) =>
  `${millis} ${Array(22).fill(angle).join(' ')}\n`;

test('a motion of RoboNewbie 1.1 is recognised by its skipped keyframes', () => {
  const old = POSE(300, 0) + POSE(20, 5) + POSE(300, 10) + POSE(39, 0) + POSE(200, 1);
  assert.ok(hasSkippedKeyframes(parse(old)) && isUndescribed(parse(`// Author: Ada\n${old}`)));
  assert.ok(!hasSkippedKeyframes(parse(POSE(300, 0) + POSE(40, 5))));
  assert.ok(!hasSkippedKeyframes(parse(POSE(300, 0) + POSE(20, 0))), 'a pause is a pause by either rule');
  assert.ok(!hasSkippedKeyframes(parse(POSE(20, 0) + POSE(20, 1) + POSE(20, 2))), 'a recorded motion');
  for (const line of ['// play: 1.1', '// columns: milliseconds', '//made by: hand', '// Start: stance']) {
    assert.ok(!isUndescribed(parse(`${line}\n${old}`)), line);
  }
  assert.equal(textOf(asOriginal(parse('// x\r\n'))), '// play: 1.1\r\n// x\r\n');
  assert.ok(!isUndescribed(asOriginal(parse(old))));
});
