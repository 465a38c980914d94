/** The studio that `run` opens has all rooms, shows the program that runs, and takes it over on the first save. */
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { folderWith, startCommand } from '../stage.js';
import { atEnd, slow } from '../tests.js';
import { EDITOR, newUser } from '../user.js';

const raiseArmTo = (degrees) => `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class MyRobot extends Agent {
    public static void main(String[] args) {
        new MyRobot().run(args);
    }

    @Override
    protected void think() {
        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH);
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, 4 * (${degrees} - angle));
    }
}
`;

/** Runs a program in a folder and opens the page that the command offers. */
async function run(t, files, ...words) {
  const folder = await folderWith(t, files);
  const address = await startCommand(t, folder, 'run', ...words);
  const user = await newUser(t);
  await user.visits(`${address}&theme=light&quality=lowest#program`);
  return { user, folder };
}

/** Starts the server of today's league, and returns its agent port; undefined if it is not installed and need not be. */
async function startLeagueServer(t) {
  const port = await freePort();
  const words = ['--sync', '--no-render', '--host=127.0.0.1', `--aport=${port}`, `--mport=${port + 1}`];
  const server = spawn('rcssservermj', words, { cwd: await folderWith(t), stdio: ['ignore', 'ignore', 'pipe'] });
  const ended = once(server, 'close');
  try {
    await once(server, 'spawn');
  } catch (missing) {
    assert.ok(!process.env.ROBONEWBIE_REQUIRE_TOOLS, missing);
    t.skip('RCSSServerMJ is not installed.');
    return undefined;
  }
  atEnd(t, async () => {
    server.kill('SIGINT');
    await ended;
  });
  for await (const line of createInterface({ input: server.stderr })) {
    if (line.includes('Listening for monitor connections')) {
      server.stderr.resume();
      return port;
    }
  }
  throw new Error('RCSSServerMJ ended while it was starting.');
}

/** Returns a free port after which another one is free. */
async function freePort() {
  const first = createServer();
  await once(first.listen(0, '127.0.0.1'), 'listening');
  const { port } = first.address();
  const second = createServer();
  const isFree = await once(second.listen(port + 1, '127.0.0.1'), 'listening').then(
    () => true,
    () => false,
  );
  first.close();
  second.close();
  return isFree ? port : freePort();
}

/** Looks into the Robot room until the joints of the left arm have this angle, and comes back. */
async function armIsAt(user, degrees) {
  await user.clicks('link', 'Robot');
  await user.reads('region', 'Left arm', new RegExp(`Shoulder pitch\\s+(${degrees - 1}|${degrees})\\.`));
  await user.clicks('link', 'Program');
}

slow('saving replaces the program of the process', async (t) => {
  const files = { 'MyRobot.java': raiseArmTo(30) };
  const { user, folder } = await run(t, files, 'MyRobot.java', '--team', 'Blue', '--number', '7', '--seed', '1');
  await user.sees('MyRobot.java is running.');
  await armIsAt(user, 30);

  await user.writes(raiseArmTo(70));
  await user.clicks('button', 'Save');

  await armIsAt(user, 70);
  await user.sees('MyRobot.java is running.');
  await user.clicks('link', 'Robot');
  assert.equal(await user.reads('combobox', 'Robot', 'Blue'), 'Blue 7');
  assert.match(readFileSync(join(folder, 'MyRobot.java'), 'utf8'), /\(70 - angle\)/);
});

slow('an example becomes a program of the user when it is saved', async (t) => {
  const { user, folder } = await run(t, {}, 'Agent_BasicStructure', '--seed', '1');
  const copy = join(folder, 'MyBasicStructure.java');
  await user.sees('Agent_BasicStructure is running; saving makes your copy MyBasicStructure.java.');
  for (const room of ['Field', 'Program', 'Robot', 'Motion', 'Replay', 'Exercises']) {
    await user.finds('link', room);
  }
  assert.equal(existsSync(copy), false);

  const program = await user.reads('textbox', EDITOR, 'class MyBasicStructure');
  await user.writes(program.replace('class MyBasicStructure', 'class  MyBasicStructure'));
  await user.clicks('button', 'Save');

  await user.sees('MyBasicStructure.java is running.');
  await user.seesNo('Agent_BasicStructure is running');
  assert.match(readFileSync(copy, 'utf8'), /class {2}MyBasicStructure extends/);
});

slow('a T1 plays the program that is saved', async (t) => {
  const port = await startLeagueServer(t);
  if (port === undefined) {
    return;
  }
  const { user } = await run(
    t,
    { 'MyRobot.java': raiseArmTo(30) },
    'MyRobot.java',
    '--robot',
    'T1',
    '--port',
    `${port}`,
  );
  await user.sees('MyRobot.java is running.');
  await user.findsNo('link', 'Exercises'); // they are for a NAO
  await user.findsNo('button', 'Step');
  await armIsAt(user, -119); // 0° is above the head

  await user.writes(raiseArmTo(70));
  await user.clicks('button', 'Save');

  await armIsAt(user, -159);
  await user.sees('MyRobot.java is running.');
});
