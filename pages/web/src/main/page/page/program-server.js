/** Local replacement for the program server: the user's files, the compiler of the page, and the running program. */
import { decodeText } from '../state/decoded-text.js';
import { isProgramPath } from '../state/program/documents.js';
import { versionOf } from './browser-repository.js';
import { insteadOfMissing } from './missing-classes.js';
import { publicClass } from './project.js';

/** @typedef {import('./program-repository.js').ProgramRepository} ProgramRepository */

const SEED = 1;

const EXAMPLES = [
  'Agent_Wave',
  'Agent_BasicStructure',
  'Agent_Dance',
  'Agent_SmoothDance',
  'Agent_SimpleWalkToBall',
  'Agent_SimpleSoccer',
  'Agent_Reactive',
  'Agent_OwnWorldModel',
  'Agent_BetterSoccer',
];

/** @param {string} path @returns {string} the name of the class in a file */
const className = (path) => (path.split('/').at(-1) ?? '').replace(/\.java$/, '');

/** @param {Response} answer @param {string} name @returns {Promise<Response>} an example as the user's program */
async function renamed(answer, name) {
  const text = await answer.text();
  const [, old = name] = /public (?:final )?class (\w+)/.exec(text) ?? [];
  const own = text.replace(/^package [^;]*;\s*/, '').replaceAll(new RegExp(`\\b${old}\\b`, 'g'), name);
  return new Response(own, { status: answer.status });
}

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
   * @param {import('./history-store.js').HistoryStore} histories
   */
  constructor(compiler, world, repository, agents, histories) {
    this.#repository = repository;
    this.histories = histories;
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

  /** @param {string} place path after `programs` @param {RequestInit} options @returns {Promise<Response>} */
  async answer(place, options) {
    const [path, search = ''] = place.split('?');
    const [, kind = '', ...rest] = path.split('/');
    const name = rest.map(decodeURIComponent).join('/');
    const wish = new URLSearchParams(search);
    const body = decodeText(new Uint8Array(await new Response(options.body).arrayBuffer())).content;
    const known = new Headers(options.headers).get('Known-Version') ?? '';
    if (['own', 'draft', 'history'].includes(kind) && !isProgramPath(name)) {
      const refusal = `"${name}" is not a valid program name. Use letters, digits and _, such as MyAgent.java.`;
      return new Response(refusal, { status: 400 });
    }
    switch (`${options.method ?? 'GET'} ${kind}`) {
      case 'GET ':
        return Response.json({
          open: true,
          folder: 'this browser',
          own: this.#repository.own,
          drafts: this.#repository.drafts,
          shared: this.#repository.shared,
          examples: EXAMPLES,
        });
      case 'GET own':
      case 'GET draft':
        return file(this.#repository.read(kind === 'own' ? 'own' : 'draft', name), name);
      case 'GET example':
        return template(name);
      case 'GET new':
        return renamed(await template(wish.get('example')), className(name));
      case 'GET history':
        return new Response(await this.histories.read(name));
      case 'PUT history':
        await this.histories.write(name, body);
        return new Response('');
      case 'PUT own':
        return this.#repository.overwrite(name, body, known);
      case 'PUT draft':
        return this.#repository.writeDraft(name, body, known);
      case 'DELETE draft':
        this.#repository.removeDraft(name, known);
        return new Response('');
      case 'POST check':
        return Response.json((await this.#compile(name, body)).remarks);
      case 'POST complete':
        return Response.json(await this.compiler.complete(this.#sources(name, body), Number(wish.get('at'))));
      case 'POST run':
        return Response.json(await this.#start(name, wish.get('world') === 'keep'));
      case 'GET run':
        return Response.json(this.#run);
      case 'DELETE run':
        this.world.postMessage({ stopProgram: true });
        this.#run = { ...this.#run, state: 'STOPPED' };
        return Response.json(this.#run);
      default:
        return new Response('Unknown request. Reload the page.', { status: 404 });
    }
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

/** @param {string | null} name name of an example; null or empty for a minimal program @returns {Promise<Response>} its source */
async function template(name) {
  const answer = await fetch(`examples/${name ? `${name}.java` : 'NewProgram.java.txt'}`);
  return answer.ok ? answer : new Response(`There is no program "${name}".`, { status: 404 });
}

/** @param {string | null} text @param {string} name */
function file(text, name) {
  return text === null
    ? new Response(`There is no program "${name}" in this browser.`, { status: 404 })
    : new Response(text, { headers: { Version: versionOf(text) } });
}
