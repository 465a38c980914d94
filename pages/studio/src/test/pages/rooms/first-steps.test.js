/** First visit of the field: three first steps, a gamepad, and a program with errors. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

const NOT_A_SPEED = `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class Walk extends Agent {
    public static void main(String[] args) {
        new Walk().run(args);
    }

    @Override
    protected void think() {
        nao.setJointSpeed(Joint.NECK_YAW, Double.NaN);
    }
}
`;

/** Opens the field at double speed. */
const openField = (t) => openStudio(t, { speed: 2 });

async function addsAPuppet(user) {
  await user.clicks('button', 'Tools ▾');
  await user.clicks('button', 'Add a puppet');
  await user.sees('You are steering Puppets 1');
}

/** Waits until so many of the first steps are crossed out. */
async function crossedOut(user, number) {
  const steps = await user.finds('region', 'First steps');
  await user.until(() =>
    steps.evaluate((region, wanted) => {
      const lines = [...region.querySelectorAll('li')].map((item) => getComputedStyle(item).textDecorationLine);
      return lines.length === 3 && lines.filter((line) => line === 'line-through').length === wanted;
    }, number),
  );
}

slow('three steps are crossed out when they are done, and then gone for good', async (t) => {
  const { user, visit } = await openField(t);
  await crossedOut(user, 0);

  await user.seesNo('Drawing the pitch…');
  await user.drags(await user.pointOf(0, 0, 0.04), await user.pointOf(1, 1, 0.04));
  await crossedOut(user, 1);
  await addsAPuppet(user);
  await user.presses('w');
  await crossedOut(user, 2);
  await user.clicks('link', 'Motion');
  await user.clicks('link', 'Field');

  await user.findsNo('region', 'First steps');
  await visit();
  await user.findsNo('region', 'First steps');
});

slow('the steps are dismissed permanently', async (t) => {
  const { user, visit } = await openField(t);

  await user.clicks('button', 'Got it');

  await user.findsNo('region', 'First steps');
  await visit();
  await user.findsNo('region', 'First steps');
});

slow('a puppet is steered with a gamepad', async (t) => {
  const { user, stage } = await openField(t);
  const puppet = async () => (await stage.world()).robots[0];
  const leansForward = (axis) => user.page.evaluate((value) => (window.pad.axes[1] = value), axis);
  await addsAPuppet(user);
  await user.page.evaluate(() => {
    window.pad = { connected: true, axes: [0, 0, 0, 0], buttons: Array(16).fill({ pressed: false }) };
    navigator.getGamepads = () => [null, window.pad];
  });
  await user.sees('Gamepad: left stick walks');
  const { x } = (await puppet()).place;

  await leansForward(-1);

  await user.until(async () => (await puppet()).place.x > x + 0.1);
  await leansForward(0);
  await user.until(() => stands(user, stage));
});

/** Returns whether the first robot stays where it is for a second of the world. */
async function stands(user, stage) {
  const before = await stage.world();
  await user.until(async () => (await stage.world()).cycle > before.cycle + 50);
  const [one, other] = [before.robots[0].place, (await stage.world()).robots[0].place];
  return Math.hypot(one.x - other.x, one.y - other.y) < 0.002;
}

slow('a mistake of a program is shown on the picture whichever robot is watched', async (t) => {
  const { user } = await openStudio(t, { room: 'program', robots: [{}], files: { 'Walk.java': NOT_A_SPEED } });
  await user.clicks('button', '▶ Run');
  await user.sees('Walk.java is running.');

  await user.clicks('link', 'Field');

  const mistakes = await user.reads('region', 'Program errors', 'NECK_YAW');
  assert.equal(mistakes.split('NECK_YAW').length, 2);
  await user.clicks('button', 'Dismiss');
  await user.findsNo('region', 'Program errors');
});
