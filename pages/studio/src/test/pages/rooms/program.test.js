/** A student writes a program beside the robot, runs it, changes it and makes mistakes. */
import assert from 'node:assert/strict';
import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { quick, slow } from '../tests.js';
import { openStudio } from '../user.js';

const raiseArmTo = (degrees) => `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class MyAgent extends Agent {
    public static void main(String[] args) {
        new MyAgent().run(args);
    }

    @Override
    protected void think() {
        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 4 * (${degrees} - angle));
    }
}
`;

const openProgram = (t, options = {}) => openStudio(t, { room: 'program', ...options });

function armIsAt({ user, stage }, degrees) {
  return user.until(async () => Math.abs((await stage.world()).robots[0]?.degrees.LEFT_SHOULDER_PITCH - degrees) < 2);
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

slow('a mistake is shown below its line and goes when it is fixed', async (t) => {
  const { user } = await openProgram(t);

  await user.writes(raiseArmTo('degres'));

  await user.sees('1 error, line 12');
  await user.sees('cannot find symbol');
  await user.writes(raiseArmTo(45));
  await user.seesNo('cannot find symbol');
});

slow('a saved change replaces the running program and the world goes on', async (t) => {
  const studio = await openProgram(t, { files: { 'MyAgent.java': raiseArmTo(45) } });
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

slow('what another program writes appears', async (t) => {
  const { user, folder } = await openProgram(t, { files: { 'MyAgent.java': raiseArmTo(45) } });
  await user.sees('(45 - angle)');

  await writeFile(join(folder, 'MyAgent.java'), raiseArmTo(-30));

  await user.sees('(-30 - angle)');
});
