/** Local replacement for the program server: the user's files, the compiler of the page, and the running program. */
import { decodeText } from '../state/decoded-text.js';
import { bytesOf } from './browser-repository.js';
import { insteadOfMissing } from './missing-classes.js';
import { publicClass } from './project.js';

/** @typedef {import('./program-repository.js').ProgramRepository} ProgramRepository */

const SEED = 1;

/** Name of the class in the templates of new programs; that of the Java class ExampleSources, which has written them. */
const TEMPLATE = 'NewProgram';

/** @param {string} path @returns {string} the name of the class in a file */
const className = (path) => (path.split('/').at(-1) ?? '').replace(/\.java$/, '');

/** @param {RequestInit} options @returns {Promise<string>} the text in the body of a request */
const textOf = async (options) => decodeText(await bytesOf(options)).content;

export class ProgramServer {
  #repository;
  #run = { id: 0, state: 'NONE', program: '', output: '', exitCode: 0, entersFirst: true };

  /** Class of the most recently started program, on the pitch or in an exercise. */
  lastTried = '';

  /**
   * @param {import('./page-compiler.js').PageCompiler} compiler
   * @param {import('./world-process.js').World} world
   * @param {ProgramRepository} repository
   * @param {{others: string[]}} agents example agents that play alongside a program
   */
  constructor(compiler, world, repository, agents) {
    this.#repository = repository;
    this.agents = agents;
    this.compiler = compiler;
    this.world = world;
  }

  /** @param {string} text state, exit code and output of the program, separated by tabs */
  receive(text) {
    const [state, exitCode, ...output] = text.split('\t');
    if (state !== 'NONE') {
      this.#run = { ...this.#run, state, exitCode: Number(exitCode), output: output.join('\t') };
    }
  }

  /** @param {string} reason why the program cannot run here */
  refused(reason) {
    this.#run = { ...this.#run, state: 'ENDED', exitCode: 1, output: `${reason}\n${insteadOfMissing(reason)}` };
  }

  /** Called when another program has taken over the world. */
  forget() {
    this.#run = { ...this.#run, state: this.#run.state === 'RUNNING' ? 'STOPPED' : this.#run.state };
  }

  /** Request handlers. */
  get parts() {
    return /** @satisfies {Record<string, import('./page-server.js').Part>} */ ({
      'GET programs': () => Response.json({ open: true, shared: this.#repository.shared }),
      'GET programs/new/PATH': ({ PATH, example }) => newProgram(example, className(PATH)),
      'POST programs/check/PATH': async ({ PATH }, options) =>
        Response.json((await this.#compile(PATH, await textOf(options))).remarks),
      'POST programs/complete/PATH': async ({ PATH, at }, options) =>
        Response.json(await this.compiler.complete(this.#sources(PATH, await textOf(options)), at)),
      'POST programs/run/PATH': async ({ PATH, world }) => Response.json(await this.#start(PATH, world === 'keep')),
      'GET programs/run': () => Response.json(this.#run),
      'DELETE programs/run': () => this.#stop(),
    });
  }

  #stop() {
    this.world.postMessage({ stopProgram: true });
    this.#run = { ...this.#run, state: 'STOPPED' };
    return Response.json(this.#run);
  }

  /** @param {string} path path of a saved program @returns {Promise<Int8Array[]>} its classes */
  async compiled(path) {
    const { remarks, classes } = await this.#compile(path, this.#repository.read('own', path) ?? '');
    const wrong = remarks.find(({ serious }) => serious);
    if (wrong) {
      throw new Error(`${path} does not compile. Line ${wrong.line}: ${wrong.text}`);
    }
    this.lastTried = className(path);
    return classes;
  }

  /** Starts a program; if it does not compile, the previous one keeps running. @param {string} path @param {boolean} keep */
  async #start(path, keep) {
    const { remarks, classes } = await this.#compile(path, this.#repository.read('own', path) ?? '');
    const run = { ...this.#run, id: this.#run.id + 1, state: 'RUNNING', program: path, output: '', exitCode: 0 };
    if (remarks.some(({ serious }) => serious)) {
      return { ...run, state: 'REFUSED' };
    }
    this.#run = run;
    this.lastTried = className(path);
    this.world.postMessage({ program: { classes, seed: SEED, others: this.agents.others, keep } });
    return run;
  }

  /** @param {string} path @param {string} text text in the editor */
  #compile(path, text) {
    return this.compiler.compile(this.#sources(path, text), path);
  }

  /** Returns the file in the editor and those that it references. @param {string} path @param {string} text */
  #sources(path, text) {
    const sources = new Map([[path, text]]);
    const classes = new Set([publicClass(text, path)]);
    for (const [other, saved] of this.#repository.texts) {
      const name = publicClass(saved, other);
      if (other !== path && !classes.has(name) && text.includes(name)) {
        classes.add(name);
        sources.set(other, saved);
      }
    }
    return sources;
  }
}

/** @param {string | null} example null or empty for the shortest program @param {string} name @returns {Promise<Response>} the source of a new program */
async function newProgram(example, name) {
  const answer = await fetch(`examples/new/${example || TEMPLATE}.java`);
  return answer.ok
    ? new Response((await answer.text()).replaceAll(TEMPLATE, () => name))
    : new Response(`There is no program "${example}".`, { status: 404 });
}
