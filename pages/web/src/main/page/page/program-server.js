/** Answers what the room for programs asks its server: files of the browser, the compiler of the page, the program that runs. */
import { decodeText } from '../state/decoded-text.js';
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
  #run = { id: 0, state: 'NONE', program: '', output: '', exitCode: 0, entersFirst: true };

  /** The class of the program that was to run last, by itself or in an exercise. */
  lastTried = '';

  /**
   * @param {import('./page-compiler.js').PageCompiler} compiler
   * @param {import('./world-process.js').World} world
   * @param {ProgramRepository} shelf
   * @param {{others: string[]}} company the shipped agents that play beside a program
   */
  constructor(compiler, world, shelf, company) {
    this.#shelf = shelf;
    this.company = company;
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
    this.#run = { ...this.#run, state: 'ENDED', exitCode: 1, output: `${reason}\n${insteadOfMissing(reason)}` };
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
    const wish = new URLSearchParams(search);
    const body = decodeText(new Uint8Array(await new Response(options.body).arrayBuffer())).content;
    const known = new Headers(options.headers).get('Known-Version') ?? '';
    switch (`${options.method ?? 'GET'} ${kind}`) {
      case 'GET ':
        return Response.json({
          open: true,
          folder: 'this browser',
          own: this.#shelf.own,
          drafts: this.#shelf.drafts,
          shared: this.#shelf.shared,
          examples: EXAMPLES,
        });
      case 'GET own':
      case 'GET draft':
        return file(this.#shelf.read(kind === 'own' ? 'own' : 'draft', name), name);
      case 'GET example':
        return new Response(await this.#example(name));
      case 'GET new':
        return new Response(await this.#newProgram(name, wish.get('example') ?? ''));
      case 'PUT own':
        return this.#shelf.overwrite(name, body, known);
      case 'PUT draft':
        return this.#shelf.writeDraft(name, body, known);
      case 'DELETE draft':
        this.#shelf.removeDraft(name, known);
        return new Response('');
      case 'POST check':
        return Response.json((await this.#compile(name, body)).remarks);
      case 'POST complete':
        return Response.json(await this.compiler.complete(this.#sources(name, body), Number(wish.get('at'))));
      default:
        return Response.json(
          await this.#runs(`${options.method ?? 'GET'} ${kind}`, name, wish.get('world') === 'keep'),
        );
    }
  }

  /** @param {string} order @param {string} name @param {boolean} keep whether the world stays */
  async #runs(order, name, keep) {
    if (order === 'POST run') {
      return this.#start(name, keep);
    }
    if (order === 'DELETE run') {
      this.world.postMessage({ stopProgram: true });
      this.#run = { ...this.#run, state: 'STOPPED' };
    }
    return this.#run;
  }

  /** @param {string} path of a saved program @returns {Promise<Int8Array[]>} its classes */
  async compiled(path) {
    const { remarks, classes } = await this.#compile(path, this.#shelf.read('own', path) ?? '');
    const wrong = remarks.find(({ serious }) => serious);
    if (wrong) {
      throw new Error(`${path} does not compile. Line ${wrong.line}: ${wrong.text}`);
    }
    this.lastTried = className(path);
    return classes;
  }

  /** A program with mistakes changes nothing: the one before it goes on. @param {string} path @param {boolean} keep */
  async #start(path, keep) {
    const { remarks, classes } = await this.#compile(path, this.#shelf.read('own', path) ?? '');
    const run = { ...this.#run, id: this.#run.id + 1, state: 'RUNNING', program: path, output: '', exitCode: 0 };
    if (remarks.some(({ serious }) => serious)) {
      return { ...run, state: 'REFUSED' };
    }
    this.#run = run;
    this.lastTried = className(path);
    this.world.postMessage({ program: { classes, seed: SEED, others: this.company.others, keep } });
    return run;
  }

  /** @param {string} path @param {string} text of the editor */
  #compile(path, text) {
    return this.compiler.compile(this.#sources(path, text), path);
  }

  /** The file in the editor, and those that it names. @param {string} path @param {string} text */
  #sources(path, text) {
    const sources = new Map([[path, text]]);
    const classes = new Set([publicClass(text, path)]);
    for (const [other, saved] of this.#shelf.texts) {
      const name = publicClass(saved, other);
      if (other !== path && !classes.has(name) && text.includes(name)) {
        classes.add(name);
        sources.set(other, saved);
      }
    }
    return sources;
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
