/** Assignment as shown to pupils: the exercises selected by a teacher's link, and a button that packs the solutions for the teacher. */
import { answer } from '../live/server.js';
import { ServerFiles } from '../live/server-files.js';
import { button, byId, element, offer, setText } from '../panels/elements.js';
import { assignmentOf, isClassLink } from '../state/class-link.js';
import { decodeText } from '../state/decoded-text.js';
import { ClassWorker } from './class-worker.js';
import { storage } from './page-storage.js';
import { publicClass, withReferences } from './project.js';
import { ENDING, submissionFile, submissionLink } from './submission.js';

/** @typedef {import('../state/class-link.js').Assignment} Assignment */

const ASSIGNMENT = 'robonewbie-page-assignment';
const NAME = 'robonewbie-page-student';
const EXERCISES = '#field/exercises';

/**
 * Stores the assignment in the page's address, if there is one.
 *
 * @returns {string} error message, or empty
 */
export function takeAssignment() {
  const { hash } = location;
  if (!isClassLink(hash)) {
    return '';
  }
  history.replaceState(undefined, '', EXERCISES);
  try {
    storage().set(ASSIGNMENT, JSON.stringify(assignmentOf(hash)));
    return '';
  } catch (failure) {
    return /** @type {Error} */ (failure).message;
  }
}

const PROGRAMS = new ServerFiles('program');
const DRAFTS = new ServerFiles('program-draft');
const MOTIONS = new ServerFiles('motion');

/** @param {ServerFiles} files @param {string} path @returns {Promise<string>} */
const text = async (files, path) => decodeText((await files.read(path)).bytes).content;

/** @returns {Promise<{programs: Map<string, string>, drafts: Set<string>}>} saved programs by path, and paths of unsaved changes */
async function ownPrograms() {
  const programs = new Map();
  for (const { path } of (await PROGRAMS.list()).files) {
    programs.set(path, await text(PROGRAMS, path));
  }
  return { programs, drafts: new Set((await DRAFTS.list()).files.map(({ path }) => path)) };
}

/**
 * @param {Map<string, string>} programs all programs by path
 * @param {string[]} files paths of the solutions
 * @returns {Promise<Record<string, string>>} the solutions, and the classes and motions used by them, keyed by the names that Java expects
 */
async function filesOf(programs, files) {
  const found = new Map();
  for (const [path, content] of files.flatMap((file) => [...withReferences(programs, file)])) {
    found.set(files.includes(path) ? path : `${publicClass(content, path)}.java`, content);
  }
  const words = [...found.values()].join('\n');
  for (const { path } of (await MOTIONS.list()).files) {
    if (words.includes(`"${path}"`)) {
      found.set(`motions/${path}.txt`, await text(MOTIONS, path));
    }
  }
  return Object.fromEntries(found);
}

class AssignmentPanel {
  #assignment;
  #name = element('input', { type: 'text', id: 'class-name', autocomplete: 'name' });
  #state = element('ul', { id: 'class-state' });
  #link = element('input', {
    type: 'text',
    id: 'class-submission',
    readonly: '',
    'aria-label': 'Link for your teacher',
  });
  #said = element('p', { id: 'class-said', role: 'status' });
  element = element(
    'section',
    { id: 'class-assignment', 'aria-label': 'Exercises from your teacher' },
    element('h3', {}, 'Exercises from your teacher'),
    element('label', {}, 'Your name', this.#name),
    this.#state,
    element(
      'div',
      { class: 'scene-line' },
      button('Send to my teacher', 'Makes a link or a file with your saved programs', () => this.#send(), {
        id: 'class-send',
      }),
      button('All exercises', 'Leaves the class; your programs are kept', () => this.#leave(), { class: 'quiet' }),
    ),
    this.#said,
    this.#link,
  );

  /** @param {Assignment} assignment */
  constructor(assignment) {
    this.#assignment = assignment;
    this.#name.value = storage().get(NAME) ?? '';
    this.#name.addEventListener('change', () => storage().set(NAME, this.#name.value.trim()));
    this.#link.hidden = true;
    const others = assignment.exercises.map((name) => `[data-exercise='${name}']`).join(', ');
    const style = `#class-choice, .standings, .lessons button:not(${others || '*'}) { display: none; }`;
    this.element.append(element('style', {}, style));
    window.addEventListener('hashchange', () => this.#refresh());
    this.#refresh();
  }

  async #solutions() {
    const { lessons } = await answer('GET course');
    const files = new Map(lessons.map((/** @type {{name: string, file: string}} */ { name, file }) => [name, file]));
    const { programs, drafts } = await ownPrograms();
    return this.#assignment.exercises.map((name) => {
      const file = files.get(name);
      return { name, file, programs, state: state(file, programs, drafts) };
    });
  }

  async #refresh() {
    if (location.hash === EXERCISES) {
      const solutions = await this.#solutions();
      this.#state.replaceChildren(
        ...solutions.map(({ name, file, state: words }) => element('li', {}, `${file ?? name}: ${words}`)),
      );
    }
  }

  async #send() {
    this.#link.hidden = true;
    const worker = new ClassWorker();
    try {
      storage().set(NAME, this.#name.value.trim());
      await this.#refresh();
      await this.#offer(await worker.call('submission', await this.#submission()));
    } catch (failure) {
      setText(this.#said, /** @type {Error} */ (failure).message);
    } finally {
      worker.close();
    }
  }

  async #submission() {
    const student = this.#name.value.trim();
    if (student === '') {
      this.#name.focus();
      throw new Error('Write your name first.');
    }
    const solutions = (await this.#solutions()).filter(({ file, programs }) => programs.has(file));
    if (solutions.length === 0) {
      throw new Error(
        'There is no saved program for these exercises yet. Open an exercise and press “Edit beside the robot”.',
      );
    }
    const files = await filesOf(
      solutions[0].programs,
      solutions.map(({ file }) => file),
    );
    return { version: 1, student, ...this.#assignment, files };
  }

  /** @param {{student: string}} submission */
  async #offer(submission) {
    const file = await submissionFile(JSON.stringify(submission));
    const name = `${submission.student}${ENDING}`;
    const link = submissionLink(file, new URL('.', location.href).href);
    if (link === '') {
      offer(name, new Blob([file]));
      setText(this.#said, `The file ${name} was downloaded. Send it to your teacher.`);
      return;
    }
    this.#link.value = link;
    this.#link.hidden = false;
    this.#link.select();
    await navigator.clipboard?.writeText(link).catch(() => {});
    setText(this.#said, 'Send this link to your teacher. If the browser allows it, it is already on the clipboard.');
  }

  #leave() {
    storage().remove(ASSIGNMENT);
    location.reload();
  }
}

/** @param {string | undefined} file @param {Map<string, string>} programs @param {Set<string>} drafts */
function state(file, programs, drafts) {
  if (file === undefined) {
    return 'this page has no such exercise; tell your teacher';
  }
  const isSaved = programs.has(file);
  if (drafts.has(file)) {
    return isSaved ? 'not all changes are saved' : 'not saved yet';
  }
  return isSaved ? 'saved' : 'not begun yet';
}

/** Shows this browser's assignment, if there is one, and a link to the page for teachers. */
export function addAssignment() {
  const stored = storage().get(ASSIGNMENT);
  byId('class-choice').append(
    element('p', {}, element('a', { href: 'class.html', target: 'robonewbie-class' }, 'Grade what pupils have sent')),
  );
  if (stored !== null) {
    document.querySelector('#course .course-head')?.after(new AssignmentPanel(JSON.parse(stored)).element);
  }
}
