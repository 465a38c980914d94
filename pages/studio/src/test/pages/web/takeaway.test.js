/** Programs leave the web edition: as a project in a zip file, and as a link. */
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { folderWith } from '../stage.js';
import { quick } from '../tests.js';
import { EDITOR, newUser, openWebEdition } from '../user.js';

const GREETER = `import org.robonewbie.agent.Agent;

public class Greeter extends Agent {
    public static void main(String[] args) {
        new Greeter().run(args);
    }

    @Override
    protected void think() {
        log.info("hello"); // or: grüße
    }
}
`;

/** Unpacks a zip file and returns the folder. */
async function unpacked(t, zip) {
  const folder = await folderWith(t, { 'project.zip': zip });
  execFileSync('jar', ['xf', 'project.zip'], { cwd: folder });
  return join(folder, 'my-robot');
}

const filesIn = (project, ending) => readdirSync(project, { recursive: true }).filter((name) => name.endsWith(ending));

/** Compiles the programs of a project as its README describes. */
function compile(project) {
  const jar = filesIn(project, '.jar').find((name) => /robonewbie-[^/]*(?<!-sources|-javadoc)\.jar$/.test(name));
  const programs = filesIn(project, '.java').filter((name) => name.includes('src/main/'));
  execFileSync('javac', ['-cp', jar, '-d', 'classes', ...programs], { cwd: project });
}

const run = (project, name) =>
  execFileSync('sh', `robonewbie run src/main/java/myrobot/${name} --headless --fast --seed 1 --seconds 3`.split(' '), {
    cwd: project,
    encoding: 'utf8',
  });

quick('the downloaded project compiles and runs', async (t) => {
  const { server, user } = await openWebEdition(t, { to: '#program' });
  if (!(await (await fetch(`${server.address}project/project.json`)).text()).includes('"robonewbie"')) {
    t.skip('The web edition was built without the project.');
    return;
  }
  await user.stores('program', 'Second.java', GREETER);
  await user.clicks('button', 'Save');

  const { name, bytes } = await user.downloads(() => user.clicks('button', 'Download'));

  assert.equal(name, 'my-robot.zip');
  const project = await unpacked(t, bytes);
  const greeter = readFileSync(join(project, 'src/main/java/myrobot/Greeter.java'), 'utf8');
  assert.match(greeter, /^package myrobot;.*grüße/s);
  compile(project);
  assert.match(run(project, 'MyAgent.java'), /left shoulder 31\.2 degrees/);
  assert.match(run(project, 'Greeter.java'), /hello/);
});

quick('a link opens the program in another browser', async (t) => {
  const { user } = await openWebEdition(t, { to: '#program' });
  await user.writes(GREETER);

  await user.clicks('button', 'Link');
  await user.until(() => user.page.url().includes('shared='));

  const other = await newUser(t);
  await other.visits(user.page.url());
  const lines = (text) => text.split('\n').filter((line) => line.trim());
  assert.deepEqual(lines(await other.reads('textbox', EDITOR, 'Greeter')), lines(GREETER));
  assert.equal(new URL(other.page.url()).hash, '#program');
});
