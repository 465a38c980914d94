/** A class without accounts in the web edition: the teacher's link, the pupils' submissions, and the table. */
import assert from 'node:assert/strict';
import { gunzipSync, gzipSync } from 'node:zlib';
import { solution } from '../solutions.js';
import { slow, slowInBoth } from '../tests.js';
import { openWebEdition } from '../user.js';

const FILE = 'RaiseArms.java';
const ASSIGNMENT = '#exercises?class=raise-arms,stop-at-30&seeds=1';
const LINK = 'class.html#submission=';

/** Long enough to be compared with others. */
const GOOD = `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class RaiseArms extends Agent {
    @Override
    protected void think() {
        hold(Joint.LEFT_SHOULDER_PITCH, 60);
        hold(Joint.RIGHT_SHOULDER_PITCH, 45);
    }

    private void hold(Joint joint, double degrees) {
        double error = degrees - nao.getJointAngle(joint);
        double speed = Math.max(-100, Math.min(100, 4 * error));
        nao.setJointSpeed(joint, Math.abs(error) < 0.2 ? 0 : speed);
    }
}
`;

const packed = (work) => LINK + gzipSync(JSON.stringify(work)).toString('base64url');
const unpacked = (bytes) => JSON.parse(gunzipSync(bytes).toString());

/** Returns the link of a student whose program for an exercise is given. */
const link = (student, program, ...otherExercises) =>
  packed({ version: 1, student, seeds: 1, exercises: ['raise-arms', ...otherExercises], files: { [FILE]: program } });

async function sends(user, name) {
  await user.fills('textbox', 'Your name', name);
  await user.clicks('button', 'Send to my teacher');
}

slow('a teacher chooses exercises for a link', async (t) => {
  const { user, server } = await openWebEdition(t, { to: '#field/exercises' });
  await user.clicks('DisclosureTriangle', 'For teachers: a class without accounts');

  await user.clicks('checkbox', '2 Stop at 30 degrees');
  await user.clicks('checkbox', '1 Raise both arms');
  await user.fills('combobox', 'Trials of each program', '10');

  const expected = `${server.address}#exercises?class=raise-arms,stop-at-30&seeds=10`;
  await user.readsValue('textbox', 'Link for the class', expected);
});

slow('a pupil sees the chosen exercises and is told what is missing to send them', async (t) => {
  const { user } = await openWebEdition(t, { to: ASSIGNMENT });

  await user.sees('RaiseArms.java: not begun yet\nStopAt30.java: not begun yet');
  await user.finds('button', '1 Raise both arms first steps · 15 min');
  await user.finds('button', '2 Stop at 30 degrees first steps · 30 min');
  await user.seesNo('4 Find the ball');
  await user.clicks('button', 'Send to my teacher');
  await user.sees('Write your name first.');
  await sends(user, 'Anna');
  await user.sees('There is no saved program for these exercises yet.');
});

slow('a pupil sends a link with the program and all that it uses', async (t) => {
  const { user, server } = await openWebEdition(t, { to: ASSIGNMENT });
  const program = `${solution(FILE)}\n// Helper.of("bow") grüßt\n`;
  await user.stores('program', `${FILE}`, program);
  await user.stores('program', 'Other.java', 'public class Helper {}');
  await user.stores('program', 'Unused.java', 'public class Unused {}');
  await user.stores('motion', 'bow', 'motion\n');

  await sends(user, '../Anna');
  await user.sees('The name "../Anna" contains "/". Choose another name.');
  await sends(user, ' Anna ');

  const field = await user.finds('textbox', 'Link for your teacher');
  const sent = await field.evaluate(({ value }) => value);
  assert.ok(sent.startsWith(server.address + LINK));
  assert.deepEqual(unpacked(Buffer.from(sent.replace(/.*=/, ''), 'base64url')), {
    version: 1,
    student: 'Anna',
    seeds: 1,
    exercises: ['raise-arms', 'stop-at-30'],
    files: { [FILE]: program, 'Helper.java': 'public class Helper {}', 'motions/bow.txt': 'motion\n' },
  });
});

slow('a long submission is a file', async (t) => {
  const { user } = await openWebEdition(t, { to: ASSIGNMENT });
  const program = GOOD + Array.from({ length: 900 }, (_, i) => `// ${i * 7919}\n`).join('');
  await user.stores('program', `${FILE}`, program);

  const { name, bytes } = await user.downloads(() => sends(user, 'Zoë'));

  assert.equal(name, 'Zoë.robonewbie');
  assert.equal(unpacked(bytes).files[FILE], program);
});

slowInBoth('the programs of five students are graded', async (t) => {
  const copy = GOOD.replaceAll('hold', 'raise').replaceAll('error', 'rest');
  const cora = link('Cora', GOOD.replace('60);', '60)'), 'fly-to-the-moon');
  const { user } = await openWebEdition(t, { to: link('Anna', GOOD) });
  await user.sees('1 student, 1 program');

  const pasted = [link('Ben', copy), cora, cora.slice(0, cora.length / 2), link('Dora', GOOD), link('dora', copy)];
  await user.fills('textbox', 'Links', pasted.map((each) => `http://localhost/${each}`).join('\n'));
  await user.sees('4 students, 3 programs');
  await user.sees(/Could not be read\s+pasted, line 3: It is incomplete or damaged\./);
  await user.clicks('button', 'Grade');
  await user.sees('4 students, 3 programs.');

  const { bytes } = await user.downloads(() => user.clicks('button', 'Save grades.csv'));
  assert.equal(bytes.toString().replaceAll('\r', ''), GRADES);
  const table = await (await user.page.$('iframe')).contentFrame();
  await user.until(async () => {
    const text = await table.evaluate(() => document.body.innerText);
    return TABLE.every((line) => text.includes(line));
  });
});

const GRADES = `student,01-raise-arms,points,passed,note
Anna,10.0,10.0,1,
Ben,10.0,10.0,1,
Cora,0.0,0.0,0,This version has no exercise named fly-to-the-moon. raise-arms: It does not compile: RaiseArms.java:7: ';' expected
Dora,,,,"The name occurs 2 times: pasted, line 4; pasted, line 5. None of them was graded; remove all but one."
"pasted, line 3",,,,It is incomplete or damaged. Ask for it again.
`;
const TABLE = ['Dora\tnot graded', '3 pairs of programs are alike', '01-raise-arms\tAnna\tBen\t100 %'];

slow('a student who sent two submissions is graded when one of them is removed', async (t) => {
  const { user } = await openWebEdition(t, { to: link('dora', GOOD) });
  await user.fills('textbox', 'Links', `http://localhost/${link('Dora', GOOD)}`);
  await user.sees('1 student, 0 programs');

  await user.clicks('button', 'Remove pasted');

  await user.sees('1 student, 1 program');
});
