/** Answers what the room for programs asks its server: files of the browser, the compiler of the page, the program that runs. */
import { versionOf } from './browser-shelf.js';

/** @typedef {import('./program-shelf.js').ProgramShelf} ProgramShelf */

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

/** @param {string} name of the class @returns {string} the shortest program that moves a robot */
const shortest = (name) => `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class ${name} extends Agent {
    public static void main(String[] args) {
        new ${name}().run(args);
    }

    @Override
    protected void think() {
        double angle = nao.getJointAngle(Joint.LEFT_SHOULDER_PITCH); // degrees
        nao.setJointSpeed(Joint.LEFT_SHOULDER_PITCH, angle < 30 ? 60 : 0); // degrees per second
        log.info("left shoulder %.1f degrees", angle);
    }
}
`;

/** @param {string} path @returns {string} the name of the class in a file */
const className = (path) => (path.split('/').at(-1) ?? '').replace(/\.java$/, '');

/** @param {string} text of an example @param {string} name @returns {string} the same as a program of one's own */
function renamed(text, name) {
  const [, old = name] = /public (?:final )?class (\w+)/.exec(text) ?? [];
  return text.replace(/^package [^;]*;\s*/, '').replaceAll(new RegExp(`\\b${old}\\b`, 'g'), name);
}

export class ProgramServer {
  #shelf;
  #run = { id: 0, state: 'NONE', program: '', output: '', exitCode: 0 };

  /**
   * @param {import('./page-compiler.js').PageCompiler} compiler
   * @param {import('./world-process.js').World} world
   * @param {ProgramShelf} shelf
   */
  constructor(compiler, world, shelf) {
    this.#shelf = shelf;
    this.compiler = compiler;
    this.world = world;
  }

  /** @param {string} text state, exit code and what the program has printed, with tabs between them */
  heard(text) {
    const [state, exitCode, ...output] = text.split('\t');
    if (state !== 'NONE') {
      this.#run = { ...this.#run, state, exitCode: Number(exitCode), output: output.join('\t') };
    }
  }

  /** @param {string} reason why the program cannot run here */
  refused(reason) {
    this.#run = { ...this.#run, state: 'ENDED', exitCode: 1, output: reason };
  }

  /** Another program has the world now. */
  forget() {
    this.#run = { ...this.#run, state: this.#run.state === 'RUNNING' ? 'STOPPED' : this.#run.state };
  }

  /** @param {string} place behind `programs` @param {RequestInit} options @returns {Promise<Response>} */
  async answer(place, options) {
    const [path, search = ''] = place.split('?');
    const [, kind = '', ...rest] = path.split('/');
    const name = rest.map(decodeURIComponent).join('/');
    const body = String(options.body ?? '');
    switch (`${options.method ?? 'GET'} ${kind}`) {
      case 'GET ':
        return Response.json({
          open: true,
          folder: 'this browser',
          own: this.#shelf.own,
          drafts: this.#shelf.drafts,
          examples: EXAMPLES,
        });
      case 'GET own':
      case 'GET draft':
        return file(this.#shelf.read(kind === 'own' ? 'own' : 'draft', name), name);
      case 'GET example':
        return new Response(await this.#example(name));
      case 'GET new':
        return new Response(await this.#newProgram(name, new URLSearchParams(search).get('example') ?? ''));
      case 'PUT own':
        return this.#shelf.overwrite(name, body, new Headers(options.headers).get('Known-Version') ?? '');
      case 'PUT draft':
        this.#shelf.writeDraft(name, body);
        return new Response('');
      case 'DELETE draft':
        this.#shelf.removeDraft(name);
        return new Response('');
      case 'POST check':
        return Response.json((await this.#compile(name, body)).remarks);
      case 'POST complete':
        return Response.json([]);
      default:
        return this.#runs(`${options.method ?? 'GET'} ${kind}`, name);
    }
  }

  /** @param {string} order @param {string} name */
  async #runs(order, name) {
    if (order === 'POST run') {
      await this.#start(name);
    } else if (order === 'DELETE run') {
      this.world.postMessage({ stopProgram: true });
      this.#run = { ...this.#run, state: 'STOPPED' };
    }
    return Response.json(this.#run);
  }

  /** @param {string} path of a saved program @returns {Promise<Int8Array[]>} its classes */
  async compiled(path) {
    const { remarks, classes } = await this.#compile(path, this.#shelf.read('own', path) ?? '');
    const wrong = remarks.find(({ serious }) => serious);
    if (wrong) {
      throw new Error(`${path} does not compile. Line ${wrong.line}: ${wrong.text}`);
    }
    return classes;
  }

  /** @param {string} path */
  async #start(path) {
    const { remarks, classes } = await this.#compile(path, this.#shelf.read('own', path) ?? '');
    this.#run = { id: this.#run.id + 1, state: 'RUNNING', program: path, output: '', exitCode: 0 };
    if (remarks.some(({ serious }) => serious)) {
      this.#run.state = 'REFUSED';
    } else {
      this.world.postMessage({ program: { classes, seed: 1 } });
    }
  }

  /** @param {string} path @param {string} text of the editor */
  async #compile(path, text) {
    const sources = new Map([[path, text]]);
    for (const [other, saved] of this.#shelf.texts) {
      if (other !== path && text.includes(className(other))) {
        sources.set(other, saved);
      }
    }
    return this.compiler.compile(sources, path);
  }

  /** @param {string} name */
  async #example(name) {
    const answer = await fetch(`examples/${name}.java`);
    if (!answer.ok) {
      throw new Error(`The page has no example ${name}.`);
    }
    return answer.text();
  }

  /** @param {string} path @param {string} example */
  async #newProgram(path, example) {
    return example === '' ? shortest(className(path)) : renamed(await this.#example(example), className(path));
  }
}

/** @param {string | null} text @param {string} name */
function file(text, name) {
  return text === null
    ? new Response(`There is no program "${name}" in this browser.`, { status: 404 })
    : new Response(text, { headers: { Version: versionOf(text) } });
}
