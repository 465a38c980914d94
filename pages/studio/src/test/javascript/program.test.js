import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const state = '../../main/resources/org/robonewbie/studio/web/state';
const { lineOf, rangeOf, remarksText, withMistake } = await import(`${state}/program/remarks.js`);
const { crashOf, isUnderWay, NO_RUN, ownRobot, runText, withoutReports } = await import(`${state}/program/run.js`);
const { ChosenNumbers, numberText, stepOf, withDefault } = await import(`${state}/program/sliders.js`);
const { valuesAtLines } = await import(`${state}/program/values.js`);
const {
  classNameProblem,
  folderOfNew,
  freeName,
  isOpenToChange,
  isUnsaved,
  javaName,
  lessonOf,
  newText,
  opened,
  written,
} = await import(`${state}/program/documents.js`);

const mistake = { from: 4, to: 9, line: 2, serious: true, text: 'cannot find symbol', hint: '' };

test('a robot’s message is matched to the line of its own file only', () => {
  assert.equal(lineOf('think() failed with java.lang.Error (MyAgent.java:31)', 'src/main/java/my/MyAgent.java'), 31);
  assert.equal(lineOf('think() failed with java.lang.Error (Other.java:31)', 'MyAgent.java'), 0);
  assert.equal(lineOf('Joint speed NaN', 'MyAgent.java'), 0);
});

test('a compiler message covers at least one character, and is hidden without a place', () => {
  assert.deepEqual(rangeOf(mistake, 20), { from: 4, to: 9 });
  assert.deepEqual(rangeOf({ ...mistake, from: 20, to: 20 }, 20), { from: 19, to: 20 });
  assert.deepEqual(rangeOf({ ...mistake, to: 4 }, 20), { from: 4, to: 5 });
  assert.equal(rangeOf({ ...mistake, line: 0 }, 20), undefined);
  assert.equal(rangeOf({ ...mistake, from: -1 }, 20), undefined);
});

test('errors are counted, and the first is named with its line', () => {
  assert.equal(remarksText([]), 'No errors');
  assert.equal(remarksText([mistake]), '1 error, line 2');
  assert.equal(remarksText([mistake, { ...mistake, line: 7 }]), '2 errors, line 2');
  assert.equal(remarksText([{ ...mistake, serious: false }]), 'No errors, but a warning');
});

test('a line has one runtime error, the latest', () => {
  const first = withMistake([], { line: 13, text: 'think() has not returned for 1 s' });

  assert.deepEqual(withMistake(first, { line: 13, text: 'think() has not returned for 5 s' }), [
    { line: 13, text: 'think() has not returned for 5 s' },
  ]);
});

test('only the last five runtime errors are kept', () => {
  const many = [1, 2, 3, 4, 5, 6, 6].reduce((all, line) => withMistake(all, { line, text: 'oh' }), []);

  assert.deepEqual(
    many.map(({ line }) => line),
    [2, 3, 4, 5, 6],
  );
});

test('the state of a program is described, and an endless loop is named', () => {
  const run = { ...NO_RUN, program: 'my/MyAgent.java' };
  const output =
    '3.02 s: think() has not returned for 5 s; the run ends here. Is this an endless loop? (MyAgent.java:12)';

  assert.equal(runText({ ...run, state: 'RUNNING' }), 'MyAgent.java is running.');
  assert.equal(
    runText({ ...run, state: 'RUNNING' }, 'Agent_Wave'),
    'Agent_Wave is running; saving makes your copy MyAgent.java.',
  );
  assert.equal(runText({ ...run, state: 'ENDED' }), 'MyAgent.java has ended.');
  assert.match(runText({ ...run, state: 'ENDED', exitCode: 1, output }), /did not return \(MyAgent\.java:12\)/);
  assert.match(runText({ ...run, state: 'ENDED', exitCode: 1 }), /has failed/);
  assert.equal(isUnderWay({ ...run, state: 'STARTING' }), true);
  assert.equal(isUnderWay({ ...run, state: 'REFUSED' }), false);
});

test('an uncaught exception or a stopped loop is found in the output', () => {
  const run = { ...NO_RUN, state: 'ENDED', program: 'my/MyAgent.java', exitCode: 1 };
  const thrown =
    'hello\nException in thread "main" java.lang.Error: oh\n\tat Other.b(Other.java:3)\n\tat My.a(MyAgent.java:7)';
  const stopped = 'Stopped at MyAgent.java:5: the program has executed 5000000 instructions.\n';

  assert.deepEqual(crashOf({ ...run, output: thrown }), {
    line: 7,
    text: 'Exception in thread "main" java.lang.Error: oh',
  });
  assert.equal(crashOf({ ...run, output: stopped })?.line, 5);
  assert.equal(crashOf({ ...run, output: 'hello' }), undefined);
  assert.equal(crashOf({ ...run, output: stopped, state: 'RUNNING' }), undefined);
});

test('the output does not repeat what the robot has reported, nor name the server', () => {
  const report = 'think() failed with java.lang.Error (MyAgent.java:31)';
  const output = `Joining the server at 127.0.0.1:3100\n0.40 s: ${report}\n0.42 s: Joint speed NaN\nhello`;

  assert.equal(withoutReports(output, new Set([report])), '0.42 s: Joint speed NaN\nhello');
  assert.equal(withoutReports(output, new Set()), `0.40 s: ${report}\n0.42 s: Joint speed NaN\nhello`);
});

test('the robot of the program is the one that joined with it, even after a restart', () => {
  assert.equal(ownRobot('', ['A\t1'], ['A\t1', 'B\t2']), 'B\t2');
  assert.equal(ownRobot('B\t2', ['A\t1'], ['B\t2', 'C\t3']), 'B\t2');
  assert.equal(ownRobot('', ['A\t1'], ['A\t1']), 'A\t1');
  assert.equal(ownRobot('', [], []), '');
  assert.equal(ownRobot('', ['A\t1', 'B\t1'], ['A\t1', 'B\t1'], true), 'A\t1');
  assert.equal(ownRobot('', [], [], true), '');
});

test('plotted values are shown at the lines that plot them', () => {
  const program = 'void think() {\n  nao.plot("angle", a); nao.plot("speed", s);\n  nao.plot("other", 1);\n}';
  const values = new Map([
    ['angle', 31.23456],
    ['speed', 60],
  ]);

  assert.deepEqual(valuesAtLines(program, values), [{ line: 2, text: '31.23, 60' }]);
});

test('a Windows file keeps its line ends, and is unsaved only after a change', () => {
  const file = opened('own', 'My.java', newText('one\r\ntwo\r\n', 'v1'));
  assert.equal(file.saved, 'one\ntwo\n');
  assert.equal(written(file, 'one\nthree\n'), 'one\r\nthree\r\n');
  assert.ok(!isUnsaved(file, 'one\ntwo\n'));
  assert.ok(isUnsaved(file, 'one\nthree\n'));
  assert.ok(isUnsaved(opened('own', 'My.java', newText('a')), 'a'));
  assert.ok(!isUnsaved(opened('example', 'Agent_Wave', newText('a')), 'b'));
});

for (const [content, typed, expected] of [
  ['a\r\nb\nc\rd', 'a\nb\nc\nd', 'a\r\nb\nc\rd'],
  ['a\r\nb\nc\rd', 'a\nb\nx\nc\nd', 'a\r\nb\nx\r\nc\rd'],
  ['a\r\nb\nc\rd', 'x\nb\nc\nd', 'x\r\nb\nc\rd'],
  ['a\r\nb\nc\rd', 'a\nd', 'a\r\nd'],
  ['a\nb', 'a\nb\n', 'a\nb\n'],
  ['a\rb\r', 'a\rb'.replace('\r', '\n'), 'a\rb'],
  ['', 'a\nb', 'a\nb'],
  ['a\r\na\na\n', 'a\na\na\na\n', 'a\r\na\na\na\r\n'],
  ['a\r\n', '', ''],
]) {
  test(`unchanged lines keep their ends: ${JSON.stringify([content, typed])}`, () => {
    assert.equal(written(opened('own', 'My.java', newText(content)), typed), expected);
  });
}

test('a file that cannot be decoded is never unsaved', () => {
  const file = opened('own', 'My.java', { ...newText('a', 'v1'), problem: 'line 1 is no text.' });
  assert.ok(!isOpenToChange(file));
  assert.ok(!isUnsaved(file, 'b'));
});

test('problems of a class name are explained', () => {
  for (const good of ['My', 'Größe', 'Привет', '_a1', 'My.java', '$x']) {
    assert.equal(classNameProblem(good), '', good);
  }
  assert.equal(classNameProblem('My Agent'), 'A class name cannot contain a space.');
  assert.equal(classNameProblem('1st'), 'A class name cannot begin with “1”.');
  assert.equal(classNameProblem('a/b'), 'A class name cannot contain “/”.');
  assert.equal(classNameProblem(''), 'A class name has 1 to 80 characters.');
});

test('a new program gets a free name in the folder of its project', () => {
  const files = [{ path: 'src/main/java/my/team/MyAgent.java' }];

  assert.equal(folderOfNew(files), 'src/main/java/my/team/');
  assert.equal(folderOfNew([{ path: 'Kick.java' }]), '');
  assert.equal(freeName('MyAgent.java', [{ path: 'MyAgent.java' }, { path: 'MyAgent2.java' }]), 'MyAgent3.java');
  assert.equal(javaName(' Walker '), 'Walker.java');
  assert.equal(lessonOf('src/main/java/my/Kick.java', [{ name: 'kick', file: 'Kick.java' }])?.name, 'kick');
});

test('the bundled editor is the output of its build command', () => {
  const made = readFileSync('src/main/resources/org/robonewbie/studio/web/vendor/codemirror/codemirror.js');
  const known = readFileSync('src/vendor/codemirror.sha256', 'utf8').trim();

  assert.equal(createHash('sha256').update(made).digest('hex'), known);
});

const gain = { name: 'gain', defaultValue: 0.5, min: 0, max: 1, value: 0.5 };

test('a slider moves in round steps', () => {
  assert.equal(stepOf(gain), 0.005);
  assert.equal(stepOf({ ...gain, min: 1, max: 60 }), 0.5);
  assert.equal(stepOf({ ...gain, min: -20, max: 20 }), 0.2);
  assert.equal(stepOf({ ...gain, min: 1, max: 1000 }), 5);
  assert.equal(numberText(0.1 + 0.2), '0.3');
});

test('a slider’s value is written into the program if it is a number literal there', () => {
  const text = 'double a = number("gain", 0.5, 0, 1), b = number( "other", -1e-3d , -1, 1);';
  assert.equal(
    withDefault(text, 'gain', 0.1 + 0.2),
    'double a = number("gain", 0.3, 0, 1), b = number( "other", -1e-3d , -1, 1);',
  );
  assert.equal(
    withDefault(text, 'other', -0.25),
    'double a = number("gain", 0.5, 0, 1), b = number( "other", -0.25 , -1, 1);',
  );
  assert.equal(withDefault('number("gain", USUAL, 0, 1)', 'gain', 0.3), undefined);
  assert.equal(withDefault('number("g.in", 1, 0, 2)', 'gain', 0.3), undefined);
});

test('a restarted program gets the chosen value unless its default has changed', () => {
  const chosen = new ChosenNumbers();
  chosen.choose(gain, 0.8, 1000);
  assert.equal(chosen.shown(gain), 0.8);
  assert.equal(chosen.pendingValue(gain, 1100), undefined);
  assert.equal(chosen.pendingValue(gain, 2000), 0.8);
  assert.equal(chosen.pendingValue(gain, 2100), undefined);
  assert.equal(chosen.pendingValue({ ...gain, value: 0.8 }, 4000), undefined);
  assert.equal(chosen.pendingValue({ ...gain, defaultValue: 0.6, value: 0.6 }, 5000), undefined);
  assert.equal(chosen.shown({ ...gain, defaultValue: 0.6, value: 0.6 }), 0.6);
});
