/** A student programs in the web edition: javac and the interpreter run in the page. */
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { quick, slow } from '../tests.js';
import { EDITOR, openWebEdition } from '../user.js';

const RAISED = 'left shoulder 31.2 degrees';
const ENDLESS_LOOP = 'while (true) {\n        }';
const MORE = 'Adds an agent, up to four in total; the second and fourth play against the first and third';
const ERRORS = 'Errors found by the compiler';
const PLOTTED = 'Values that the program plots';
const LOG = 'Log of the robot';

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

/** Returns an agent with a statement of think() in line 5 and further members before it. */
const agent = (statement, members = '') => `import org.robonewbie.agent.*;
import org.robonewbie.nao.Joint;
public class MyAgent extends Agent {${members}
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
const TUNABLE = agent(
  `double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, speed.gain() * (raised - angle));
        nao.plot("arm", Math.rint(angle));
        nao.plot("gain", speed.gain());
        nao.plot("cycles", ++cycles);`,
  `
    private final double raised = number("raised", 30, 0, 90);
    private final Speed speed = new Speed(number("gain", 4, 1, 10));
    private int cycles;
    private record Speed(double gain) {}`,
);

/** Opens the Program room with a program, or with the first one of a newcomer. */
async function openProgram(t, text = '') {
  const page = await openWebEdition(t, { to: '#program' });
  page.user.expectsComplaints(REPORTS);
  if (text) {
    await page.user.writes(text);
  }
  return page;
}

const runs = (user) => user.clicks('button', '▶ Run');

const cycleOf = async (user) => Number((await user.reads('region', 'Time', /cycle \d/)).match(/cycle (\d+)/)[1]);

const hasCycle = (user, isWanted) => user.until(async () => isWanted(await cycleOf(user)));

/** Returns the simulated seconds at which the robot has logged each line that is still shown. */
async function secondsIn(user, text) {
  const log = await user.reads('list', LOG, text);
  return [...log.matchAll(/^([\d.]+) s +(.*)$/gm)]
    .filter(([, , said]) => said === text)
    .map(([, time]) => Number(time));
}

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
  const { user } = await openWebEdition(t, { to: '#program' });

  await runs(user);

  await user.reads('list', LOG, RAISED);
});

quick('a program runs in a page that was there before', async (t) => {
  const { user, visit } = await openProgram(t);
  await user.page.evaluate(async () => void (await navigator.serviceWorker.ready));
  await visit();
  assert.ok(await user.page.evaluate(() => navigator.serviceWorker.controller !== null));

  await runs(user);

  await user.reads('list', LOG, RAISED);
});

quick('a mistake is shown with its line in the words of javac', async (t) => {
  const { user } = await openProgram(t, agent('nao.sayy("x");'));

  await user.reads('list', ERRORS, /Line 5.*cannot find symbol/s);
});

quick('mistakes have hints', async (t) => {
  const { user } = await openProgram(t);
  for (const [statement, hint] of HINTS) {
    await user.writes(agent(statement));

    await user.reads('list', ERRORS, hint);
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
    agent(
      'System.out.println(new Pair(1, Mood.GLAD));',
      '\n    enum Mood { GLAD }\n    record Pair(int one, Mood other) {}',
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

    await runs(user);

    await user.reads('region', 'Output', output);
  });
}

quick('an endless loop is stopped and named, until the program is saved without it', async (t) => {
  const { user } = await openProgram(t, agent(ENDLESS_LOOP));

  await runs(user);

  const output = await user.reads('region', 'Output', 'Stopped at MyAgent.java:5');
  assert.doesNotMatch(output, /Fake/, 'shows calls of the page itself');
  const shown = await user.reads('textbox', EDITOR, /Stopped/);
  assert.equal(shown.match(/Stopped/g).length, 1);
  await user.writes(agent(''));
  await user.clicks('button', 'Save');
  await user.seesNo('Stopped at MyAgent.java:5');
});

quick('an exception is reported with its line and the robot continues', async (t) => {
  const { user } = await openProgram(t, agent('int[] numbers = {1, 2};\n        log.info("" + numbers[2]);'));

  await runs(user);

  await user.reads('region', 'Output', 'MyAgent.java:6');
  await user.sees('MyAgent.java is running.');
});

for (const text of documentedPrograms()) {
  const [, name] = text.match(/public (?:final )?class (\w+)/);
  const test = name === 'FirstProgram' ? quick : slow; // each loads the compiler anew
  test(`a program of README or tutorial runs: ${name}`, async (t) => {
    const { user } = await openProgram(t);
    await user.fills('combobox', 'Speed', 'fastest');
    await hasCycle(user, (cycle) => cycle > 3000);
    await user.fills('combobox', 'Speed', '1');
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
  await runs(user);
  const [raised] = await secondsIn(user, RAISED);
  await hasCycle(user, (cycle) => cycle > 300);

  await user.writes((await user.reads('textbox', EDITOR)).replace('angle < 30', 'angle < 60'));
  await user.presses('Control+s');

  const [raisedFurther] = await secondsIn(user, 'left shoulder 61.2 degrees');
  assert.ok(raisedFurther > raised + 5, `${raised}, ${raisedFurther}`);
});

quick('a slider changes the running robot and keeps its state', async (t) => {
  const { user } = await openProgram(t, TUNABLE);
  const cyclesIn = (values) => Number(values.match(/cycles (\d+)/)[1]);
  await runs(user);
  const before = await user.reads('group', PLOTTED, /arm 30.*cycles \d{3}/s);

  await user.fills('slider', 'raised', '60');
  await user.fills('slider', 'gain', '2');

  const after = await user.reads('group', PLOTTED, /arm 60.*gain 2/s);
  assert.ok(cyclesIn(after) > cyclesIn(before), `${before}, ${after}`);
});

quick('a program with mistakes leaves the one before in its place', async (t) => {
  const { user } = await openProgram(t);
  await runs(user);
  await secondsIn(user, RAISED);

  await user.writes('public class MyAgent {');
  await user.presses('Control+s');

  await user.reads('list', ERRORS, 'reached end of file');
  const save = await user.finds('button', 'Save');
  await user.until(() => save.evaluate(({ disabled }) => disabled));
  const logged = async () => (await secondsIn(user, RAISED)).at(-1);
  const saved = await logged();
  await user.until(async () => (await logged()) > saved + 2);
  await user.sees('MyAgent.java is running.');
});

quick('a program plays beside a shipped agent', async (t) => {
  const { user } = await openProgram(t);
  await user.fills('combobox', MORE, 'Agent_SimpleSoccer');
  await user.sees('Guests 1');

  await runs(user);

  await user.reads('list', LOG, RAISED);
  await user.sees('RoboNewbie 1');
  await user.sees('Guests 1');
  await user.seesNo(/(RoboNewbie|Guests) 2/);
});

for (const [begun, last, member, ...documentation] of [
  ['nao.setJointS', 'p', 'setJointSpeed', 'double degreesPerSecond', 'Sets the speed of a joint.'],
  ['fieldView.ball().isV', 'i', 'isVisible', 'in the last picture'],
  ['this.rais', 'e', 'raiseArm', 'Raises the arm.'],
  ['motions.sta', 'r', 'start', 'Starts a motion'],
]) {
  quick(`the editor proposes ${member} with its documentation, to choose with the mouse`, async (t) => {
    const raiseArm = '\n    /** Raises the arm. */\n    void raiseArm() {}';
    const { user } = await openProgram(t, agent(begun, raiseArm));
    await user.presses('ArrowUp', 'ArrowUp', 'ArrowUp', 'End');

    await user.types(last);

    for (const text of [member, ...documentation]) {
      await user.sees(text);
    }
    await user.page.locator('>>> .cm-tooltip-autocomplete li').click();
    await user.reads('textbox', EDITOR, `.${member}()`);
  });
}
