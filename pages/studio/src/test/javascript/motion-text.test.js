import assert from 'node:assert/strict';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import {
  changed,
  historyOf,
  redone,
  undone,
} from '../../main/resources/org/robonewbie/studio/web/state/motion/history.js';
import {
  keyframesOf,
  reversed,
  scaled,
  withInserted,
  withKeyframe,
  withMoved,
  without,
} from '../../main/resources/org/robonewbie/studio/web/state/motion/motion-document.js';
import {
  decode,
  encode,
  numberText,
  parse,
  problemOf,
  robotOf,
  textOf,
} from '../../main/resources/org/robonewbie/studio/web/state/motion/motion-text.js';
import { postureAt, timesOf } from '../../main/resources/org/robonewbie/studio/web/state/motion/timing.js';

const ANGLES = Array.from({ length: 22 }, (_, i) => i / 4).join(' ');
const FILE = `// author: Ada\r\n500 ${ANGLES}  // first\r\n\r\nnonsense\r\n300\t${ANGLES.replace('0.25', '0.250')}`;

test('a file keeps every character', () => {
  assert.equal(textOf(parse(FILE)), FILE);
  assert.deepEqual(
    keyframesOf(parse(FILE)).map(({ millis }) => millis),
    [500, 300],
  );
  assert.match(parse(FILE).lines[3].problem ?? '', /found “nonsense”, expected the time/);
});

test('an old file with umlauts keeps its bytes', () => {
  const bytes = Uint8Array.from([...new TextEncoder().encode('// Z'), 0xf6, 0x65, 0x80, 0x0a]);
  assert.deepEqual(encode(decode(bytes)), bytes);
  assert.equal(decode(bytes).encoding, 'Windows-1252');
  assert.throws(
    () => decode(Uint8Array.from([0x0a, 0x81])),
    /^Error: line 2 is neither UTF-8 nor Windows-1252 \(byte 0x81\)/,
  );
});

test('changing an angle keeps all other characters', () => {
  const degrees = keyframesOf(parse(FILE))[1].degrees.with(2, -12.375);
  const text = textOf(withKeyframe(parse(FILE), 1, { degrees }));
  assert.equal(text, FILE.replace(/0\.250 0\.5/, '0.250 -12.375'));
});

test('keyframes are inserted, removed and moved with their comments', () => {
  const document = parse(FILE);
  const frame = { millis: 40, degrees: keyframesOf(document)[0].degrees };
  const grown = withInserted(document, 2, frame);
  assert.deepEqual(
    keyframesOf(grown).map(({ millis }) => millis),
    [500, 300, 40],
  );
  assert.equal(textOf(grown).split('\r\n').length, FILE.split('\r\n').length + 2);
  assert.deepEqual(
    keyframesOf(without(grown, 0)).map(({ millis }) => millis),
    [300, 40],
  );
  const moved = withMoved(document, 0, 1);
  assert.deepEqual(
    keyframesOf(moved).map(({ millis }) => millis),
    [300, 500],
  );
  assert.ok(textOf(moved).trimEnd().endsWith('// first'));
});

test('reversing twice gives the same motion, and tempo keeps whole cycles', () => {
  const document = parse(FILE);
  assert.deepEqual(keyframesOf(reversed(reversed(document))), keyframesOf(document));
  assert.deepEqual(
    keyframesOf(scaled(document, 0.33)).map(({ millis }) => millis),
    [160, 100],
  );
});

test('numbers are written without exponent', () => {
  assert.equal(numberText(1e-7), '0.0000001');
  assert.equal(numberText(-0), '0');
  assert.equal(numberText(-12.5), '-12.5');
});

test('undo is unlimited, and one gesture is one step', () => {
  let history = historyOf(0);
  for (let i = 1; i <= 1000; i++) {
    history = changed(history, i, `step ${i}`);
  }
  history = changed(changed(history, 2000, 'drag', 'drag 1'), 3000, 'drag', 'drag 1');
  assert.equal(undone(history).present.value, 1000);
  for (let i = 0; i <= 1000; i++) {
    history = undone(history);
  }
  assert.equal(history.present.value, 0);
  assert.equal(undone(history), history);
  assert.equal(redone(history).present.value, 1);
});

test('a joint moves linearly from keyframe to keyframe', () => {
  const frames = keyframesOf(parse(FILE)).map((frame, i) => ({ ...frame, degrees: frame.degrees.map(() => 10 * i) }));
  assert.deepEqual(timesOf(frames), [500, 800]);
  assert.equal(postureAt(frames, new Array(22).fill(-10), 250)[0], -5);
  assert.equal(postureAt(frames, new Array(22).fill(-10), 650)[0], 5);
  assert.equal(postureAt(frames, new Array(22).fill(-10), 900)[0], 10);
});

test('the page parses and edits files exactly like the robot', (context) => {
  const folder = process.env.STUDIO_FRAME_FOLDER ?? '';
  const cases = existsSync(join(folder, 'motions'))
    ? readdirSync(join(folder, 'motions')).filter((name) => name.endsWith('.txt'))
    : [];
  if (cases.length === 0) {
    context.skip('run by Maven');
    return;
  }
  for (const name of cases) {
    const bytes = new Uint8Array(readFileSync(join(folder, 'motions', name)));
    const truth = JSON.parse(readFileSync(join(folder, 'motions', name.replace('.txt', '.json')), 'utf8'));
    const document = decode(bytes, truth.joints);
    assert.equal(robotOf(document), truth.robot, name);
    assert.deepEqual(encode(document), bytes, name);
    assert.deepEqual(
      keyframesOf(document).map(({ millis, degrees }) => [millis, ...degrees]),
      truth.keyframes,
      name,
    );
    assert.equal(document.lines.filter(({ problem }) => problem).length, truth.errors, name);
    truth.keyframes.forEach((/** @type {number[]} */ _, /** @type {number} */ i) => {
      const degrees = keyframesOf(document)[i].degrees.with(i % truth.joints, truth.angle);
      assert.equal(textOf(withKeyframe(document, i, { millis: 1234, degrees })), truth.changed[i], name);
    });
  }
});

test('an invalid line is reported with its number', () => {
  assert.equal(problemOf(parse('// fine\n\n')), '');
  assert.equal(
    problemOf(parse('// fine\nthis line is nonsense\n')),
    'Line 2 cannot be read: found “this”, expected the time in whole milliseconds, such as 500',
  );
  assert.match(problemOf(parse('a\nb\n')), /\(2 such lines\)$/);
});
