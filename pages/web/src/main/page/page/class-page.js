/**
 * Page for teachers: reads the links and files that pupils have sent, grades the programs, and shows the table of `robonewbie grade
 * --class`.
 */
import { button, byId, element, offer, setText } from '../panels/elements.js';
import { themeSwitch } from '../panels/theme.js';
import { ClassGrader } from './class-grader.js';
import { ClassWorker } from './class-worker.js';
import { readFile, readLinks } from './submission.js';

/**
 * @typedef {import('./submission.js').Received} Received
 * @typedef {{seeds: number, students: string[], senders: string[], programs: import('./class-grader.js').Program[], troubles: Record<string, string>}} Listed
 */

const TABLES = ['grades.html', 'grades.csv', 'findings.csv', 'copies.csv'];
const MINUTE = 60;

/** @param {number} count @param {string} word */
const counted = (count, word) => `${count} ${word}${count === 1 ? '' : 's'}`;

/** @param {number} seconds */
const timeLeft = (seconds) =>
  seconds < MINUTE ? 'less than a minute left' : `about ${Math.round(seconds / MINUTE)} min left`;

class ClassPage {
  #worker = new ClassWorker();
  #grader = new ClassGrader();
  /** @type {Received[]} */
  #received = [];
  /** @type {Listed | undefined} */
  #listed;
  #links = /** @type {HTMLTextAreaElement} */ (byId('class-links'));
  #files = /** @type {HTMLInputElement} */ (byId('class-files'));
  #seeds = /** @type {HTMLSelectElement} */ (byId('class-seeds'));
  #grade = /** @type {HTMLButtonElement} */ (byId('class-grade'));

  constructor() {
    this.#links.addEventListener('input', () => this.#takeLinks());
    this.#files.addEventListener('change', async () => {
      await this.#takeFiles([...(this.#files.files ?? [])]);
      this.#files.value = '';
    });
    this.#grade.addEventListener('click', () => this.#run());
    byId('class-stop').addEventListener('click', () => this.#grader.stop());
    byId('class-clear').addEventListener('click', () => this.#clear());
    this.#acceptDrops();
    window.addEventListener('hashchange', () => this.#takeAddress());
    this.#takeAddress();
  }

  #acceptDrops() {
    const room = byId('class-room');
    const drop = (/** @type {DragEvent} */ event, /** @type {boolean} */ isOver) => {
      event.preventDefault();
      room.dataset.dropping = String(isOver);
    };
    document.addEventListener('dragover', (event) => drop(event, true));
    document.addEventListener('dragleave', (event) => drop(event, false));
    document.addEventListener('drop', async (event) => {
      drop(event, false);
      const files = [...(event.dataTransfer?.files ?? [])];
      const text = event.dataTransfer?.getData('text') ?? '';
      await (files.length > 0 ? this.#takeFiles(files) : this.#add(await readLinks(text, 'dropped')));
    });
  }

  async #takeAddress() {
    const { hash } = location;
    history.replaceState(undefined, '', location.pathname);
    await this.#add(await readLinks(hash, 'opened link'));
  }

  /** Reads the links in the text area, and clears it if there are any. */
  async #takeLinks() {
    const found = await readLinks(this.#links.value, 'pasted');
    if (found.length > 0) {
      this.#links.value = '';
      await this.#add(found);
    }
  }

  /** @param {File[]} files */
  async #takeFiles(files) {
    await this.#add((await Promise.all(files.map(readFile))).flat());
  }

  /** @param {Received[]} found */
  async #add(found) {
    const known = new Set(this.#received.map((each) => JSON.stringify(each)));
    this.#received = [...this.#received, ...found.filter((each) => !known.has(JSON.stringify(each)))];
    await this.#list();
  }

  async #clear() {
    this.#received = [];
    byId('class-result').hidden = true;
    setText(byId('class-progress'), '');
    await this.#list();
  }

  async #list() {
    const received = this.#received;
    const before = this.#listed?.seeds;
    const listed = /** @type {Listed} */ (await this.#worker.call('programs', { received }));
    if (received !== this.#received) {
      return; // another call lists the submissions changed in the meantime
    }
    this.#listed = listed;
    const { students, senders, programs, seeds } = listed;
    if (seeds !== before) {
      this.#seeds.value = [...this.#seeds.options].find(({ value }) => Number(value) >= seeds)?.value ?? '3';
    }
    setText(
      byId('class-count'),
      received.length === 0 ? '' : `${counted(students.length, 'student')}, ${counted(programs.length, 'program')}`,
    );
    const entries = received.map((each, index) => ({ received: each, student: senders[index] }));
    const known = entries.filter(({ student }) => student !== '');
    const unreadable = entries.filter(({ student }) => student === '');
    known.sort((first, second) => first.student.localeCompare(second.student));
    byId('class-students').replaceChildren(...known.map((entry) => this.#entry(entry, listed)));
    byId('class-unreadable').hidden = unreadable.length === 0;
    document
      .querySelector('#class-unreadable ul')
      ?.replaceChildren(...unreadable.map((entry) => this.#entry(entry, listed)));
    this.#grade.disabled = received.length === 0;
  }

  /** @param {{received: Received, student: string}} entry @param {Listed} listed */
  #entry({ received, student }, { programs, troubles }) {
    const { source } = received;
    const trouble = troubles[student || source] ?? '';
    const count = programs.filter((program) => program.student === student).length;
    const graded =
      count === 0 && trouble !== ''
        ? `${student} (${source}): not graded.`
        : `${student}: ${counted(count, 'program')}.`;
    const words = student === '' ? `${source}: ${trouble}` : `${graded} ${trouble}`;
    const remove = button('Remove', `Removes ${source}`, () => this.#remove(received), {
      class: 'quiet',
      'aria-label': `Remove ${source}`,
    });
    return element('li', { 'data-trouble': String(trouble !== '') }, words, remove);
  }

  /** @param {Received} received */
  async #remove(received) {
    this.#received = this.#received.filter((each) => each !== received);
    await this.#list();
  }

  async #run() {
    const { programs } = /** @type {Listed} */ (this.#listed);
    const seeds = Number(this.#seeds.value);
    this.#setRunning(true);
    try {
      const marks = await this.#grader.grade(programs, seeds, (done, seconds) =>
        this.#progress(done, programs, seconds),
      );
      await this.#show(marks, seeds, programs.length);
    } catch (failure) {
      setText(byId('class-progress'), /** @type {Error} */ (failure).message);
    } finally {
      this.#setRunning(false);
    }
  }

  /** @param {boolean} isRunning */
  #setRunning(isRunning) {
    for (const control of [this.#links, this.#files, this.#seeds, this.#grade]) {
      control.disabled = isRunning;
    }
    byId('class-stop').hidden = !isRunning;
    byId('class-share').hidden = !isRunning;
    if (isRunning) {
      setText(byId('class-progress'), 'Loading compiler and simulator…');
      byId('class-share').setAttribute('value', '0');
    }
  }

  /** @param {number} done @param {unknown[]} programs @param {number} seconds */
  #progress(done, programs, seconds) {
    byId('class-share').setAttribute('value', String(done / programs.length));
    setText(byId('class-progress'), `${done} of ${counted(programs.length, 'program')} graded, ${timeLeft(seconds)}`);
  }

  /** @param {import('./class-grader.js').Mark[]} marks @param {number} seeds @param {number} count number of programs */
  async #show(marks, seeds, count) {
    const files = await this.#worker.call('table', { received: this.#received, marks, seeds });
    const stopped = marks.length < count ? `Stopped after ${marks.length} of ${counted(count, 'program')}. ` : '';
    setText(byId('class-progress'), stopped + files.sentence);
    /** @type {HTMLIFrameElement} */ (byId('class-table')).srcdoc = files['grades.html'];
    byId('class-saving').replaceChildren(
      ...TABLES.map((name) =>
        button(`Save ${name}`, 'Saves this file', () =>
          offer(name, files[name], name.endsWith('.csv') ? 'text/csv' : 'text/html'),
        ),
      ),
    );
    byId('class-result').hidden = false;
  }
}

themeSwitch(new URLSearchParams(location.search).get('theme'), () => {});
new ClassPage();
navigator.serviceWorker?.register('service-worker.js').catch(() => {});
