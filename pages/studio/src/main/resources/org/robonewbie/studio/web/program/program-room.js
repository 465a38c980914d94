/** The program room: editor, compiler and the running program, next to the robot. */
import { element } from '../panels/elements.js';
import { sidePanel } from '../panels/side-panel.js';
import { isOpenToChange, programAt } from '../state/program/documents.js';
import { remarksText } from '../state/program/remarks.js';
import { CodeEditor } from './code-editor.js';
import { ExerciseController } from './exercise-controller.js';
import { FileController } from './file-controller.js';
import { FirstMinute } from './first-minute.js';
import { HistoryController } from './history-controller.js';
import { ProgramService } from './program-service.js';
import { RunController } from './run-controller.js';
import { SaidPanel } from './said-panel.js';

/**
 * @typedef {object} Surroundings
 * @property {(text: string) => void} note
 * @property {() => void} clearErrors dismisses the errors shown on top of the 3D view
 * @property {() => void} goLive
 * @property {(starting: string) => void} announce
 * @property {(command: object) => void} send
 * @property {() => readonly import('../live/state-frame.js').Player[]} robots returns the robots currently on the pitch
 * @property {() => boolean} isPitchEmpty whether the pitch has no robots and puppets can join
 */

const CHECK_MILLISECONDS = 300;

/** @param {Surroundings} surroundings */
export async function openProgramRoom(surroundings) {
  const room = new ProgramRoom(surroundings);
  await room.open();
  return room;
}

class ProgramRoom {
  #ready = Promise.resolve();
  #checkTimer = 0;
  #checks = 0;

  /** @param {Surroundings} surroundings */
  constructor(surroundings) {
    this.surroundings = surroundings;
    this.service = new ProgramService();
    const code = sidePanel('program', 'code');
    const said = sidePanel('program', 'said');
    this.bar = element('div', { class: 'program-bar' });
    this.notes = element('div', { class: 'program-notes' });
    const place = element('div', { id: 'program-editor' });
    /** Controls below the program: for running it, and for less frequent actions. */
    this.foot = element('div', { class: 'program-foot' });
    code.append(this.bar, this.notes, place, this.foot);
    this.editor = new CodeEditor(place, {
      changed: () => this.#changed(),
      complete: (context) => this.#complete(context),
      save: () => this.attempt(() => this.save()),
      run: () => this.attempt(() => this.runs.run()),
    });
    this.said = new SaidPanel(said, (line) => this.editor.goTo(line));
    this.files = new FileController(this);
    this.runs = new RunController(this);
    this.history = new HistoryController(this);
    this.exercises = new ExerciseController(this);
    this.firstMinute = new FirstMinute(this);
  }

  /** Opens the first file; the user's actions wait until it is open. */
  open() {
    this.#ready = this.#open();
    return this.#ready;
  }

  async #open() {
    const list = await this.service.list();
    if (!list.open) {
      return;
    }
    await this.exercises.open();
    await this.files.open(list);
    if (programAt(location.hash) === '') {
      await this.firstMinute.open();
    }
    await this.#followAddress();
    addEventListener('hashchange', () => this.attempt(() => this.#followAddress()));
    await this.runs.look();
  }

  /** Opens the exercise or program specified in the address. */
  async #followAddress() {
    const wanted = programAt(location.hash);
    if (wanted !== '') {
      history.replaceState(undefined, '', '#program');
      await this.files.choose(this.exercises.has(wanted) ? `exercise ${wanted}` : `own ${wanted}`);
    }
  }

  /** Key actions of this room outside of the editor. */
  get actions() {
    const action = (/** @type {string} */ key, /** @type {string} */ text, /** @type {() => Promise<void>} */ act) => ({
      keys: [key],
      ctrl: true,
      shown: `Ctrl+${key === 'Enter' ? key : key.toUpperCase()}`,
      text,
      act: () => this.attempt(act),
    });
    return [
      action('s', 'save the program; if it is running, it is replaced immediately', () => this.save()),
      action('Enter', 'run the program', () => this.runs.run()),
    ];
  }

  /** @returns {boolean} whether there is work that is stored neither in its file nor in a draft */
  get isAtRisk() {
    return this.files.isAtRisk;
  }

  /** Runs an action and reports any failure. @param {() => Promise<void>} action */
  attempt(action) {
    this.#ready.then(action).catch((error) => this.surroundings.note(error.message));
  }

  /** Saves the program, and hot-swaps it if it is running. */
  async save() {
    if (await this.files.save()) {
      await this.runs.saved();
    }
  }

  /** Called when another file is shown. */
  opened() {
    this.exercises.draw();
    this.firstMinute.opened();
    this.runs.forgetMistakes();
    this.attempt(() => this.check());
  }

  /** @param {{robot: string, lines: string[]}} news telemetry of a robot */
  receive(news) {
    this.runs.receive(news);
  }

  /** Repeats the requests to the simulator, after another room has replaced them or the simulator has changed. */
  forget() {
    this.runs.forgetRobot();
  }

  /** Compiles the editor's text. */
  async check() {
    clearTimeout(this.#checkTimer);
    const { file } = this.files;
    if (!file || !isOpenToChange(file)) {
      this.#showRemarks([]);
      return;
    }
    this.#checks += 1;
    const mine = this.#checks;
    const text = this.editor.text;
    const remarks = await this.service.check(file.path, text);
    if (mine === this.#checks && text === this.editor.text) {
      this.#showRemarks(remarks);
    }
  }

  /** @param {readonly import('../state/program/remarks.js').Remark[]} remarks */
  #showRemarks(remarks) {
    this.editor.setRemarks(remarks);
    this.said.showRemarks(remarks);
    this.runs.showRemarks(remarksText(remarks), remarks);
  }

  #changed() {
    this.files.changed();
    this.runs.edited();
    this.firstMinute.draw();
    clearTimeout(this.#checkTimer);
    this.#checkTimer = window.setTimeout(() => this.attempt(() => this.check()), CHECK_MILLISECONDS);
  }

  /** @type {import('@codemirror/autocomplete').CompletionSource} */
  async #complete(context) {
    const word = context.matchBefore(/\w*/);
    const before = context.matchBefore(/\.\s*\w*/);
    const { file } = this.files;
    if (!file || !word || (!context.explicit && !before && word.text.length < 2)) {
      return null;
    }
    const proposals = await this.service.complete(file.path, this.editor.text, context.pos);
    const options = proposals.map(({ label, detail, kind, insert, documentation }, i) => ({
      label,
      detail,
      type: kind,
      apply: applied(insert),
      info: documentation || undefined,
      boost: -i / 100,
    }));
    return { from: word.from, options, validFor: /^\w*$/ };
  }
}

/**
 * Inserts a completion; after an opening parenthesis, completion continues with the arguments.
 *
 * @param {string} insert
 * @returns {string | ((view: import('@codemirror/view').EditorView, chosen: unknown, from: number, to: number) => void)}
 */
function applied(insert) {
  if (!insert.endsWith('(')) {
    return insert;
  }
  return (view, _chosen, from, to) => {
    const selection = { anchor: from + insert.length };
    view.dispatch({ changes: { from, to, insert: `${insert})` }, selection, userEvent: 'input.complete' });
  };
}
