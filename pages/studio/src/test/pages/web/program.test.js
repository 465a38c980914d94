/** A student programs in the web edition: javac and the interpreter run in the page. */
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { quick } from '../tests.js';
import { EDITOR, openWebEdition } from '../user.js';

const RAISED = 'left shoulder 31.2 degrees';
const ENDLESS_LOOP = 'while (true) {\n        }';

/** Warnings and errors of a robot are in the browser's console, too. */
const REPORTS = /^\d+\.\d\d s: /;

const HINTS = [
  ['new Thread(() -> {}).start();', 'This page has no threads'],
  ['new org.robonewbie.exercises.Grader();', 'press Check'],
  ['new java.util.Scanner(System.in);', 'cannot use files or the keyboard'],
  ['java.time.Instant.now();', 'nao.getTime()'],
  ['nao.setJointSped(0);', 'Did you mean setJointSpeed?'],
  ['new Vector3(1, 2, 3);', 'Add at the top of the file: import org.robonewbie.nao.Vector3;'],
  ['org.robonewbie.nao.motion.Posture.ZERO.zzz();', 'Posture has the methods'],
  ['int a = 1', 'Something is missing just before this point'],
];

const agent = (statement) => `import org.robonewbie.agent.*;
import org.robonewbie.nao.Joint;
public class MyAgent extends Agent {
    protected void think() {
        ${statement}
    }
}
`;
const program = (statements) => `import org.robonewbie.agent.Nao;
public class MyAgent {
    public static void main(String[] args) {
        ${statements}
    }
}
`;

/** Opens the Program room with a program, or with the first one of a newcomer. */
async function openProgram(t, text = '') {
  const page = await openWebEdition(t, { to: '#program' });
  if (text) {
    await page.user.writes(text);
  }
  return page;
}

const runs = (user) => user.clicks('button', '▶ Run');

const hasCycle = (user, isWanted) =>
  user.until(async () => isWanted(Number((await user.reads('region', 'Time')).match(/cycle (\d+)/)?.[1])));

/** Returns the programs of README and tutorial that have a main method. */
function documentedPrograms() {
  const root = new URL('../../../../../../', import.meta.url);
  const pages = readdirSync(new URL('docs/tutorial', root)).filter((name) => name.endsWith('.md'));
  return ['README.md', ...pages.sort().map((name) => `docs/tutorial/${name}`)]
    .map((name) => readFileSync(new URL(name, root), 'utf8'))
    .flatMap((page) => [...page.matchAll(/^```java\n(.*?)^```/gms)].map(([, text]) => text))
    .filter((text) => text.includes('void main(') && /public (final )?class/.test(text));
}

quick('the first program raises the arm to 31 degrees', async (t) => {
  const { user } = await openProgram(t);

  await runs(user);

  await user.sees(RAISED);
});

quick('a program runs in a page that was there before', async (t) => {
  const { user, visit } = await openProgram(t);
  await user.page.evaluate(async () => void (await navigator.serviceWorker.ready));
  await visit();
  assert.ok(await user.page.evaluate(() => navigator.serviceWorker.controller !== null));

  await runs(user);

  await user.sees(RAISED);
});

quick('a mistake stands at its line in the words of javac', async (t) => {
  const { user } = await openProgram(t, agent('nao.sayy("x");'));

  await user.reads('list', 'Errors found by the compiler', /Line 5.*cannot find symbol/s);
});

quick('mistakes have hints', async (t) => {
  const { user } = await openProgram(t);
  for (const [statement, advice] of HINTS) {
    await user.writes(agent(statement));

    await user.reads('list', 'Errors found by the compiler', advice);
  }
});

for (const [what, text, output] of [
  [
    'a program with Nao is suspended in the middle',
    program(`try (Nao nao = Nao.connect(args)) {
            nao.perform("wave");
            System.out.println("waved until " + nao.getTime());
        }`),
    'waved until',
  ],
  [
    'enumerations and records of a program work',
    agent('System.out.println(new Pair(1, Mood.GLAD));').replace(
      '{\n',
      '{\n    enum Mood { GLAD }\n    record Pair(int one, Mood other) {}\n',
    ),
    'Pair[one=1, other=GLAD]',
  ],
  [
    'a wrong value is reported with its line',
    agent('nao.setJointAngle(Joint.LEFT_KNEE_PITCH, 500);'),
    'it is limited to the range. (MyAgent.java:5)',
  ],
]) {
  quick(what, async (t) => {
    const { user } = await openProgram(t, text);
    user.expectsComplaints(REPORTS);

    await runs(user);

    await user.reads('region', 'Output', output);
  });
}

quick('an endless loop is stopped and named, until the program is saved without it', async (t) => {
  const { user } = await openProgram(t, agent(ENDLESS_LOOP));

  await runs(user);

  const output = await user.reads('region', 'Output', 'Stopped at MyAgent.java:5');
  assert.doesNotMatch(output, /Fake/, 'shows calls of the page itself');
  const said = await user.reads('textbox', EDITOR, /Stopped/);
  assert.equal(said.match(/Stopped/g).length, 1);
  await user.writes(agent(''));
  await user.clicks('button', 'Save');
  await user.seesNo('Stopped at MyAgent.java:5');
});

quick('an exception is reported with its line and the robot continues', async (t) => {
  const { user } = await openProgram(t, agent('int[] numbers = {1, 2};\n        log.info("" + numbers[2]);'));
  user.expectsComplaints(REPORTS);

  await runs(user);

  await user.reads('region', 'Output', 'MyAgent.java:6');
  await user.sees('MyAgent.java is running.');
});

for (const text of documentedPrograms()) {
  const [, name] = text.match(/public (?:final )?class (\w+)/);
  quick(`a program of README or tutorial runs: ${name}`, async (t) => {
    const { user } = await openProgram(t);
    user.expectsComplaints(REPORTS);
    await user.fills('combobox', 'Speed', 'fastest');
    await hasCycle(user, (cycle) => cycle > 3000);
    await user.writes(text);

    await runs(user);

    await hasCycle(user, (cycle) => cycle > 100 && cycle < 3000);
    await user.sees(/MyAgent\.java (is running|has ended)\./);
    assert.doesNotMatch(await user.reads('region', 'Output'), /Exception|is not available/);
  });
}

quick('a page without a robot shows what to do', async (t) => {
  const { user } = await openProgram(t, program('System.out.println("done");'));
  await runs(user);
  await user.reads('region', 'Output', 'done');

  await user.clicks('link', 'Field');

  await user.sees('Choose an agent in the toolbar');
});

quick('a saved change replaces the running program and the world goes on', async (t) => {
  const { user } = await openProgram(t);
  const ball = () => user.page.evaluate(() => studio.state.frame.ball);
  await runs(user);
  await user.sees(RAISED);
  await hasCycle(user, (cycle) => cycle > 300);
  const before = await ball();

  await user.writes((await user.reads('textbox', EDITOR)).replace('angle < 30', 'angle < 60'));
  await user.presses('Control+s');

  await user.sees('left shoulder 61.2 degrees');
  await hasCycle(user, (cycle) => cycle > 300);
  assert.deepEqual(await ball(), before);
});

quick('a slider changes the running robot and keeps its state', async (t) => {
  const { user } = await openProgram(
    t,
    agent(`double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, speed.gain() * (raised - angle));
        nao.plot("arm", Math.rint(angle));
        nao.plot("gain", speed.gain());
        nao.plot("cycles", ++cycles);`).replace(
      '{\n',
      `{
    private final double raised = number("raised", 30, 0, 90);
    private final Speed speed = new Speed(number("gain", 4, 1, 10));
    private int cycles;
    private record Speed(double gain) {}
`,
    ),
  );
  await runs(user);
  await user.reads('group', 'Values that the program plots', 'arm 30');

  await user.fills('slider', 'raised', '60');
  await user.fills('slider', 'gain', '2');

  const values = await user.reads('group', 'Values that the program plots', /arm 60.*gain 2/s);
  assert.ok(Number(values.match(/cycles (\d+)/)[1]) > 50);
});

quick('a program with mistakes leaves the one before in its place', async (t) => {
  const { user } = await openProgram(t);
  await runs(user);
  await user.sees(RAISED);

  await user.writes('public class MyAgent {');
  await user.presses('Control+s');

  await user.reads('list', 'Errors found by the compiler', 'reached end of file');
  await user.sees('MyAgent.java is running.');
});

quick('a program plays beside a shipped agent', async (t) => {
  const { user } = await openProgram(t);
  const title = 'Adds an agent, up to four in total; the second and fourth play against the first and third';
  await user.fills('combobox', title, 'Agent_SimpleSoccer');
  await user.sees('Guests 1');

  await runs(user);

  await user.sees(RAISED);
  await user.sees('RoboNewbie 1');
  await user.sees('Guests 1');
});

for (const [before, last, proposal, ...documentation] of [
  ['nao.setJointS', 'p', 'setJointSpeed', 'double degreesPerSecond', 'Sets the speed of a joint.'],
  ['fieldView.ball().i', 's', 'isVisible', 'in the last picture'],
  ['this.rais', 'e', 'raiseArm', 'Raises the arm.'],
  ['motions.sta', 'r', 'start', 'Starts a motion'],
]) {
  quick(`the editor proposes ${proposal} with its documentation, to choose with the mouse`, async (t) => {
    const raiseArm = '{\n    /** Raises the arm. */\n    void raiseArm() {}\n';
    const { user } = await openProgram(t, agent(before).replace('{\n', raiseArm));
    await user.presses('ArrowUp', 'ArrowUp', 'ArrowUp', 'End');

    await user.types(last);

    for (const text of [proposal, ...documentation]) {
      await user.sees(text);
    }
    await user.page.locator('>>> .cm-tooltip-autocomplete li').click();
    await user.reads('textbox', EDITOR, `.${proposal}(`);
  });
}
