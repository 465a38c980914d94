/** A student writes a program beside the robot, runs it, changes it, makes mistakes, and solves an exercise. */
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { quick, slow } from '../tests.js';
import { EDITOR, FOR_PICTURES, openStudio } from '../user.js';

const thinking = (...lines) => `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class MyAgent extends Agent {
    public static void main(String[] args) {
        new MyAgent().run(args);
    }

    @Override
    protected void think() {
        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
        ${lines.join('\n        ')}
    }
}
`;
const atSpeed = (speed) => `nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, ${speed});`;
const raiseArmTo = (degrees) => thinking(atSpeed(`4 * (${degrees} - angle)`));

const TUNABLE = raiseArmTo('raised').replace(
  '    @Override',
  `    private final double raised = number("raised", 30, 0, 90);

    {
        System.out.println("process " + ProcessHandle.current().pid());
    }

    @Override`,
);

const RAISE_ARMS = `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class RaiseArms extends Agent {
    @Override
    protected void think() {
        hold(Joint.LEFT_SHOULDER_PITCH, 60);
        hold(Joint.RIGHT_SHOULDER_PITCH, 45);
    }

    private void hold(Joint joint, double degrees) {
        nao.setJointSpeed(joint, 4 * (degrees - nao.getJointAngle(joint)));
    }
}
`;

const openProgram = (t, options = {}) => openStudio(t, { room: 'program', ...options });
const openWith = (t, program, options = {}) => openProgram(t, { files: { 'MyAgent.java': program }, ...options });

function armIsAt({ user, stage }, degrees) {
  return user.until(async () => Math.abs((await stage.world()).robots[0]?.degrees.LEFT_SHOULDER_PITCH - degrees) < 2);
}

const count = (text, part) => text.split(part).length - 1;
const process = async (user) => /process \d+/.exec(await user.reads('region', 'Output', /process \d+/))[0];

/** Reads a mistake of the running program once in the output and once below its line. */
async function readsOneMistake(user, mistake) {
  await user.reads('textbox', EDITOR, mistake);
  assert.equal(count(await user.reads('textbox', EDITOR), mistake), 1);
  assert.equal(count(await user.reads('list', 'Errors of the running program', mistake), 'Line '), 1);
}

async function seesNoMistake(user) {
  await user.findsNo('list', 'Errors of the running program');
  assert.doesNotMatch(await user.reads('textbox', EDITOR), /think\(\) (failed|has not returned)/);
}

quick('the first program moves the arm after one click', async (t) => {
  const studio = await openProgram(t);
  const { user, folder } = studio;

  await user.clicks('button', '▶ Run');

  await user.sees('MyAgent.java is running.');
  await armIsAt(studio, 31);
  assert.match(await readFile(join(folder, 'MyAgent.java'), 'utf8'), /public class MyAgent extends Agent/);
  await user.clicks('button', '■ Stop');
  await user.sees('MyAgent.java was stopped.');
});

for (const theme of ['light', 'dark']) {
  slow(`the ${theme} program beside its robot is worth a picture`, async (t) => {
    const plot = 'nao.plot("x", 3);';
    const program = thinking(plot, atSpeed('4 * (60 - angle)'));
    const studio = await openWith(t, program, { theme, ...FOR_PICTURES });
    const { user } = studio;

    await user.clicks('button', '▶ Run');

    await armIsAt(studio, 60);
    await user.reads('textbox', EDITOR, `${plot}= 3`);
    await user.takesAPicture(`program-${theme}`);
    await user.writes(raiseArmTo('degres'));
    await user.sees('1 error');
    await user.page.setViewport({ width: 1024, height: 768 });
    await user.takesAPicture(`program-mistake-${theme}`);
  });
}

slow('a mistake is shown below its line and goes when it is fixed', async (t) => {
  const { user } = await openProgram(t);

  await user.writes(raiseArmTo('degres'));

  await user.sees('1 error, line 12');
  await user.reads('textbox', EDITOR, /- angle\)\);\s+cannot find symbol/);
  await user.writes(raiseArmTo(45));
  await user.seesNo('cannot find symbol');
});

slow('a saved change replaces the running program and the world goes on', async (t) => {
  const studio = await openWith(t, raiseArmTo(45));
  const { user, stage, folder } = studio;
  await user.clicks('button', '▶ Run');
  await armIsAt(studio, 45);
  const { cycle } = await stage.world();

  await user.writes(raiseArmTo(-20));
  await user.presses('Control+s');

  await armIsAt(studio, -20);
  assert.ok((await stage.world()).cycle > cycle);
  assert.match(await readFile(join(folder, 'MyAgent.java'), 'utf8'), /-20/);
});

slow('a slider acts on the running robot and is written into the program', async (t) => {
  const studio = await openWith(t, TUNABLE);
  const { user, folder } = studio;
  await user.clicks('button', '▶ Run');
  await armIsAt(studio, 30);
  const first = await process(user);

  await user.fills('slider', 'raised', '60');

  await armIsAt(studio, 60);
  assert.equal(await process(user), first);
  await user.clicks('button', 'Write to the program');
  await user.reads('textbox', EDITOR, 'number("raised", 60, 0, 90)');
  await user.clicks('button', 'Save');
  await user.until(async () => (await process(user)) !== first);
  await user.reads('group', 'Adjustable numbers in the program', /raised\s+60/);
  await armIsAt(studio, 60);
  assert.match(await readFile(join(folder, 'MyAgent.java'), 'utf8'), /number\("raised", 60, 0, 90\)/);
});

slow('an endless loop ends and its line is named', async (t) => {
  const loop = ['while (angle < 1e9) {', '    angle += 0;', '}'];
  const { user } = await openWith(t, thinking(atSpeed(0), ...loop));

  await user.clicks('button', '▶ Run');

  await user.sees('was stopped: think() did not return (MyAgent.java:1');
  await readsOneMistake(user, 'think() has not returned');
  await user.writes(raiseArmTo(45));
  await user.clicks('button', 'Save');
  await user.sees('No program is running');
  await seesNoMistake(user);
  assert.doesNotMatch(await user.reads('region', 'Output'), /has not returned/);
});

slow('an exception is shown at its line and values beside theirs', async (t) => {
  const { user } = await openWith(t, thinking(atSpeed(0), 'nao.plot("angle", 7);', 'int oh = 1 / (int) (angle * 0);'));

  await user.clicks('button', '▶ Run');

  await user.reads('list', 'Errors of the running program', 'Line 14');
  await user.reads('textbox', EDITOR, /int oh = .*\s+think\(\) failed/);
  await user.reads('textbox', EDITOR, 'nao.plot("angle", 7);= 7');
  await user.clicks('button', '■ Stop');
});

slow('an exception is shown once and is gone when it is fixed', async (t) => {
  const studio = await openWith(t, thinking(atSpeed('1 / (int) (angle * 0)')));
  const { user } = studio;
  await user.clicks('button', '▶ Run');
  await readsOneMistake(user, 'think() failed');
  await user.sees('MyAgent.java is running.');
  const output = await user.reads('region', 'Output');
  assert.equal(count(output, 'think() failed'), 1);
  assert.doesNotMatch(output, /Called from/);
  await user.clicks('link', 'Robot');
  await user.finds('combobox', 'Robot');
  await user.clicks('link', 'Program');

  await user.writes(raiseArmTo(45));
  await user.clicks('button', 'Save');

  await armIsAt(studio, 45);
  await seesNoMistake(user);
  assert.doesNotMatch(await user.reads('region', 'Output'), /failed/);
  await user.findsNo('region', 'Program errors');
  assert.equal(await user.page.$eval('#toast', (toast) => toast.textContent), '');
});

for (const width of [1366, 1024]) {
  slow(`long lines are wrapped in a window of ${width} pixels`, async (t) => {
    const long = raiseArmTo(45).replace('angle));', 'angle)); // degrees per second, at most 351');
    const { user } = await openWith(t, long, { width });

    await user.reads('textbox', EDITOR, 'at most 351');

    const editor = await user.finds('textbox', EDITOR);
    assert.ok(await editor.evaluate(({ parentElement: box }) => box.scrollWidth <= box.clientWidth));
  });
}

slow('line numbers stay beside their lines when the editor becomes narrower', async (t) => {
  const { user } = await openWith(t, raiseArmTo(30));
  const editor = await user.finds('textbox', EDITOR);

  await user.page.evaluate((program) => {
    const room = studio.rooms.program;
    room.editor.replace(program);
    room.editor.view.measure();
    document.querySelector('#program-editor').style.marginRight = '300px';
  }, raiseArmTo(45));

  await user.until(() => editor.evaluate((lines) => lines.scrollHeight > 21 * lines.children.length));
  await user.until(() =>
    editor.evaluate((lines) => {
      const numbers = [...lines.parentElement.querySelectorAll('.cm-lineNumbers .cm-gutterElement')];
      const tops = (all) => [...all].map((each) => each.getBoundingClientRect().top).join();
      return tops(numbers.filter((each) => each.offsetHeight > 0)) === tops(lines.children);
    }),
  );
});

slow('the first exercise is solved and checked', async (t) => {
  const { user } = await openProgram(t);
  await user.fills('combobox', 'Program', 'exercise raise-arms');
  await user.finds('button', 'Check');
  await user.writes(RAISE_ARMS);

  await user.clicks('button', 'Check');

  await user.sees('Passed: 10.0 of 10 points');
  await user.clicks('button', 'Back to the free pitch');
  await user.seesNo('Passed: 10.0 of 10 points');
});

slow('the panel of exercises leads to the program beside the robot', async (t) => {
  const { user } = await openStudio(t, { room: 'field/exercises' });
  await user.clicks('button', '1 Raise both arms first steps · 15 min');

  await user.clicks('button', 'Edit beside the robot');

  await user.finds('button', 'Check');
  await user.readsValue('combobox', 'Program', 'own RaiseArms.java');
  await user.reads('textbox', EDITOR, 'class RaiseArms');
  assert.equal(new URL(user.page.url()).hash, '#program');
});

slow('Step lets the world go on by one cycle', async (t) => {
  const studio = await openWith(t, raiseArmTo(45));
  const { user, stage } = studio;
  await user.clicks('button', '▶ Run');
  await armIsAt(studio, 45);
  await user.clicks('button', 'Step');
  await user.until(async () => (await stage.world()).isPaused);
  const { cycle } = await stage.world();

  await user.clicks('button', 'Step');

  await user.until(async () => (await stage.world()).cycle > cycle);
  const now = await stage.world();
  assert.deepEqual([now.isPaused, now.cycle], [true, cycle + 1]);
});

slow('what is not saved is there after the browser has ended', async (t) => {
  const { user, visit, folder } = await openWith(t, raiseArmTo(45));
  const draft = join(folder, '.studio/programs/MyAgent.java');
  await user.writes(raiseArmTo(50));
  await user.until(() => existsSync(draft) && readFileSync(draft, 'utf8').includes('(50 - angle)'));

  await visit();

  await user.reads('textbox', EDITOR, '(50 - angle)');
  assert.match(await readFile(join(folder, 'MyAgent.java'), 'utf8'), /\(45 - angle\)/);
});

slow('what another program writes appears', async (t) => {
  const { user, folder } = await openWith(t, raiseArmTo(45));
  await user.reads('textbox', EDITOR, '(45 - angle)');

  await writeFile(join(folder, 'MyAgent.java'), raiseArmTo(-30));

  await user.reads('textbox', EDITOR, '(-30 - angle)');
});
