/** Studios for the tests, which run in one Java process. */
import { execFile, spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { delimiter, dirname, join } from 'node:path';
import { createInterface } from 'node:readline';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { atEnd } from './tests.js';

/** Class path of the tests of `app`, as it is after `./mvnw package`. */
const PACKAGED = ['app/target/test-classes', 'pages/studio/target/test-classes', 'app/target/robonewbie.jar']
  .map((path) => fileURLToPath(new URL(`../../../../../${path}`, import.meta.url)))
  .join(delimiter);
const JAVA = [
  '-XX:TieredStopAtLevel=1',
  '-XX:+UseSerialGC',
  '-Xshare:auto',
  '-cp',
  process.env.STAGE_CLASS_PATH ?? PACKAGED,
];

let shared;
after(() => shared?.process.stdin.end());

/** Starts the process, which answers each line with a line. */
function startStage() {
  const process = spawn('java', [...JAVA, 'org.robonewbie.studio.Stage'], { stdio: ['pipe', 'pipe', 'inherit'] });
  const answers = createInterface({ input: process.stdout })[Symbol.asyncIterator]();
  let last = Promise.resolve();

  async function asked(request) {
    process.stdin.write(`${JSON.stringify(request)}\n`);
    const { value, done } = await answers.next();
    const { error, ...answer } = done ? { error: 'The Java process has ended.' } : JSON.parse(value);
    if (error) {
      throw new Error(error);
    }
    return answer;
  }

  function ask(request) {
    const answer = last.then(() => asked(request));
    last = answer.catch(() => undefined);
    return answer;
  }
  return { process, ask };
}

/**
 * Starts a command that opens a studio in its own process, such as `run MyRobot.java`, until the test ends.
 *
 * @param {import('node:test').TestContext} t
 * @param {string} folder its working directory
 * @param {...string} words the command and its arguments
 * @returns {Promise<string>} the address of the page, which works once
 */
export function startCommand(t, folder, ...words) {
  return startJava(t, folder, 'org.robonewbie.app.Main', ...words, '--no-browser');
}

/** Starts a Java program that opens a studio, and returns the address of the page. */
export async function startJava(t, folder, ...words) {
  const env = { ...process.env, ROBONEWBIE_RECORDINGS: 'off' };
  const started = spawn('java', [...JAVA, ...words], { cwd: folder, env, stdio: ['ignore', 'pipe', 'inherit'] });
  const ended = once(started, 'close');
  atEnd(t, async () => {
    started.kill('SIGKILL');
    await ended;
  });
  for await (const line of createInterface({ input: started.stdout })) {
    const [, address] = /(?:Watch it at|^Studio:) (\S+)/.exec(line) ?? [];
    if (address) {
      started.stdout.resume();
      return address;
    }
  }
  throw new Error(`${words.join(' ')} has ended without an address.`);
}

/**
 * Runs a command to its end, such as `grade kick Kick.java`, whatever its exit code is.
 *
 * @param {string} folder its working directory
 * @param {...string} words the command and its arguments
 * @returns {Promise<string>} its standard output
 */
export function runCommand(folder, ...words) {
  return runJava(folder, 'org.robonewbie.app.Main', ...words);
}

/** Runs a Java program to its end, whatever its exit code is, and returns its standard output. */
export async function runJava(folder, ...words) {
  const env = { ...process.env, ROBONEWBIE_PROGRESS: join(folder, 'progress.json') };
  const { stdout } = await promisify(execFile)('java', [...JAVA, ...words], { cwd: folder, env }).catch(
    (ended) => ended,
  );
  return stdout;
}

/**
 * Makes a folder that is deleted after the test.
 *
 * @param {import('node:test').TestContext} t
 * @param {Record<string, string | Uint8Array>} files names and contents
 */
export async function folderWith(t, files = {}) {
  const folder = await mkdtemp(join(tmpdir(), 'robonewbie-'));
  atEnd(t, () => rm(folder, { recursive: true, force: true, maxRetries: 5 }));
  for (const [name, content] of Object.entries(files)) {
    await mkdir(dirname(join(folder, name)), { recursive: true });
    await writeFile(join(folder, name), content);
  }
  return folder;
}

/**
 * What a studio shows: robots that hold a posture, or a world that waits for its first robot.
 *
 * @typedef {{ side?: 'LEFT' | 'RIGHT', number?: number, type?: number, x?: number, y?: number, heading?: number,
 *   posture?: Record<string, number> }} Robot one of the left team comes first; the posture has degrees by names of joints
 * @typedef {{ robots?: Robot[], isPlaying?: boolean, isPaused?: boolean, landscape?: string, speed?: number, language?: 'en' | 'de',
 *   recordings?: string[], openedRecording?: string, search?: object, hasWall?: boolean, isForeign?: boolean }} World `isPlaying` adds a
 *   robot of the team Stars that nods, raises an arm too fast and shouts; `recordings` are names of recordings to make in the folder: four
 *   seconds with a goal and a fall (those in its folder `project` are of the student's project), `openedRecording` one of them that is
 *   opened with the studio; `search` is the task of an optimisation, shown instead of the course, `hasWall` shows the wall of a contest
 *   instead; `isForeign` shows the world as that of another process, through its monitor port
 */

/**
 * Opens a studio until the test ends.
 *
 * @param {import('node:test').TestContext} t
 * @param {string} folder folder of its programs, motions, recordings and progress
 * @param {World} world
 */
export async function openStage(t, folder, world) {
  const { ask } = (shared ??= startStage());
  const { id, agentPort, drawingPort } = await ask({ do: 'open', folder, ...world });
  let closing;
  const close = () => (closing ??= ask({ do: 'close', id }));
  atEnd(t, close);
  return {
    /** Number of this studio, for the wall of another one. */
    id,

    /** Returns an address of the page, which works once. */
    address: async () => (await ask({ do: 'address', id })).address,

    /** Writes a page file to a folder, which leads to such an address, and returns its path. */
    pageFile: async (to) => (await ask({ do: 'pageFile', id, folder: to })).path,

    /** Publishes news on the wall of a contest, see StagedWall.java. */
    wall: (news) => ask({ do: 'wall', id, ...news }),

    /** Changes the world by a command of the page, such as `{do: 'step', cycles: 50}`. */
    order: (order) => ask({ do: 'order', id, order }),

    /** Returns cycle, isPaused, speed, playMode, score, ball `{x, y, z}`, and robots with team, number, place, heading and degrees. */
    world: () => ask({ do: 'world', id }),

    /** Sends a line of telemetry as from a robot's program, such as `log\t1.2\tBlue_Newbies\t1\tINFO\tI see the ball`. */
    tell: (...fields) => ask({ do: 'tell', id, line: fields.join('\t') }),

    /** Reports that number 1 of the left team runs into an opponent. */
    callFoul: () => ask({ do: 'foul', id }),

    /** Ends the simulator and the studio, as Ctrl+C does. */
    end: () => ask({ do: 'end', id }),

    /** Starts another simulator with a studio at the same address, after the end of the first. */
    restart: (other) => ask({ do: 'restart', id, folder, ...other }),

    /** TCP port for programs of robots. */
    agentPort,

    /** UDP port for drawings in the protocol of RoboViz. */
    drawingPort,

    /** Publishes news of the optimisation, see StagedSearch.java, and returns whether a page shows it. */
    search: async (news = {}) => (await ask({ do: 'search', id, news })).isWatched,

    close,
  };
}
