/** Local replacement for the file server: the user's files, which this browser stores, and those that are part of the page. */
import { decodeText } from '../state/decoded-text.js';
import { composedName, isProgramPath, nameProblem } from '../state/file-name.js';
import { asBytes, asText, BrowserRepository, bytesOf, versionOf } from './browser-repository.js';

/** @typedef {import('../live/server-files.js').ListedFile} ListedFile */

/**
 * @typedef {object} Files files of one kind
 * @property {() => ListedFile[] | Promise<ListedFile[]>} list
 * @property {(path: string) => Response | Promise<Response>} read
 * @property {(path: string, bytes: Uint8Array, known: string | null) => Response | Promise<Response>} write
 * @property {(path: string, known: string | null) => Response | void} remove
 * @property {(path: string) => string} refusal why the path is not allowed, or empty
 */

const refuse = () => new Response('This file cannot be changed here.', { status: 405 });

/** Files that cannot be changed. */
const READ_ONLY = { write: refuse, remove: refuse, refusal: () => '' };

/** @param {string} path */
const programRefusal = (path) =>
  isProgramPath(path) ? '' : `"${path}" is not a valid program name. Use letters, digits and _, such as MyAgent.java.`;

/** @param {string} name */
function motionRefusal(name) {
  const problem = nameProblem(composedName(name));
  return problem && `"${name}" is not a valid motion name: it ${problem}. Choose another one.`;
}

/** @param {Uint8Array} bytes */
const decoded = (bytes) => decodeText(bytes).content;

/** @param {BodyInit | null} content @param {string} version @param {string} path */
const file = (content, version, path) =>
  content === null
    ? new Response(`There is no file "${path}" in this browser.`, { status: 404 })
    : new Response(content, { headers: { Version: version } });

/** @param {string} address */
async function shipped(address) {
  const answer = await fetch(address);
  return answer.ok ? answer : new Response('There is no file with this name.', { status: 404 });
}

export class FileServer {
  #motions = new BrowserRepository('robonewbie-page-motion:');
  #programs;
  #histories;
  /** Called after one of the user's motions has been saved. */
  changed = () => {};

  /**
   * @param {import('./program-repository.js').ProgramRepository} programs
   * @param {import('./history-store.js').HistoryStore} histories
   */
  constructor(programs, histories) {
    this.#programs = programs;
    this.#histories = histories;
    /** @type {Record<string, Files>} */
    this.kinds = {
      ...this.#programKinds,
      motion: this.#motionKind(this.#motions, ''),
      'motion-draft': this.#motionKind(new BrowserRepository('robonewbie-page-motion-draft:'), null),
      'motion-library': { ...READ_ONLY, list: () => listed('library'), read: (name) => shipped(`library/${name}.txt`) },
      postures: this.#motionKind(new BrowserRepository('robonewbie-page-postures:'), null, ''),
    };
  }

  /** @returns {[string, Int8Array][]} name and bytes of each motion of the user */
  get motions() {
    return this.#motions.list.map(({ path }) => [path, new Int8Array(asBytes(this.#motions.read(path) ?? '').buffer)]);
  }

  /** @returns {Record<string, Files>} */
  get #programKinds() {
    const programs = this.#programs;
    /** @param {'own' | 'draft'} kind @param {string} path */
    const read = (kind, path) => {
      const text = programs.read(kind, path);
      return file(text, versionOf(text ?? ''), path);
    };
    return {
      program: {
        list: () => programs.own,
        read: (path) => read('own', path),
        write: (path, bytes, known) => programs.overwrite(path, decoded(bytes), known ?? ''),
        remove: refuse,
        refusal: programRefusal,
      },
      'program-draft': {
        list: () => programs.drafts,
        read: (path) => read('draft', path),
        write: (path, bytes, known) => programs.writeDraft(path, decoded(bytes), known),
        remove: (path, known) => programs.removeDraft(path, known),
        refusal: programRefusal,
      },
      'program-history': {
        list: () => [],
        read: async (path) => new Response(await this.#histories.read(path)),
        write: async (path, bytes) => {
          await this.#histories.write(path, decoded(bytes));
          return new Response('');
        },
        remove: refuse,
        refusal: programRefusal,
      },
      example: {
        ...READ_ONLY,
        list: () => listed('examples'),
        read: (name) => shipped(`examples/${name}.java`),
      },
    };
  }

  /**
   * @param {BrowserRepository} repository
   * @param {string | null} unread the known version of a writer who does not name one
   * @param {string | null} missing the content of a file that does not exist
   * @returns {Files}
   */
  #motionKind(repository, unread, missing = null) {
    return {
      list: () => repository.list,
      read: (name) => {
        const text = repository.read(name) ?? missing;
        return file(text === null ? null : asBytes(text), versionOf(text ?? ''), name);
      },
      write: (name, bytes, known) => {
        const answer = repository.overwrite(name, asText(bytes), known ?? unread);
        this.changed();
        return answer;
      },
      remove: unread === null ? (name, known) => repository.remove(name, known) : refuse,
      refusal: motionRefusal,
    };
  }

  /** Request handlers. */
  get parts() {
    return /** @satisfies {Record<string, import('./page-server.js').Part>} */ ({
      'GET files/KIND': async ({ KIND }) =>
        Response.json({ folder: 'this browser', files: await this.kinds[KIND].list(), leftOut: [] }),
      'GET files/KIND/PATH': this.#part((files, path) => files.read(path)),
      'PUT files/KIND/PATH': this.#part(async (files, path, options) =>
        files.write(path, await bytesOf(options), knownVersion(options)),
      ),
      'DELETE files/KIND/PATH': this.#part(
        (files, path, options) => files.remove(path, knownVersion(options)) ?? new Response(''),
      ),
    });
  }

  /**
   * @param {(files: Files, path: string, options: RequestInit) => Response | Promise<Response>} act
   * @returns {import('./page-server.js').Part}
   */
  #part(act) {
    return ({ KIND, PATH }, options) => {
      const files = this.kinds[KIND];
      const refusal = files.refusal(PATH);
      return refusal ? new Response(refusal, { status: 400 }) : act(files, PATH, options);
    };
  }
}

/** @param {RequestInit} options */
const knownVersion = ({ headers }) => new Headers(headers).get('Known-Version');

/** @param {string} folder @returns {Promise<ListedFile[]>} the files in its index */
async function listed(folder) {
  const index = decoded(await bytesOf(await fetch(`${folder}/index`)));
  return index
    .split('\n')
    .filter(Boolean)
    .map((path) => ({ path, version: '' }));
}
