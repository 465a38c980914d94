/** Which program is open: chooses, opens, makes, saves; keeps what is unsaved; takes over what an IDE writes meanwhile. */
import { ask } from '../motion/questions.js';
import { button, byId, choice, element } from '../panels/elements.js';
import { keep, recall } from '../panels/memory.js';
import {
  FIRST_NAME,
  folderOfNew,
  freeName,
  isUnsaved,
  javaName,
  normal,
  opened,
  written,
} from '../state/program/documents.js';
import { fileName } from '../state/program/remarks.js';
import { fillChoice } from './file-choice.js';
import { note } from './program-room.js';

/**
 * @typedef {import('./program-service.js').ProgramList} ProgramList
 * @typedef {import('../state/program/documents.js').OpenFile} OpenFile
 */

const KEY = 'robonewbie-program';
const DRAFT_MILLISECONDS = 400;
const LOOK_MILLISECONDS = 1000;
const NAME = /^[\p{L}_$][\p{L}\p{N}_$]{0,79}(\.java)?$/u;
const NAME_HINT = 'The name of a class: letters and digits, a capital letter first.';

export class FileDesk {
  #draftTimer = 0;
  #isDraftKept = true;
  #looking = false;

  /** @param {any} room */
  constructor(room) {
    this.room = room;
    this.service = room.service;
    this.editor = room.editor;
    /** @type {ProgramList} */
    this.list = { open: true, folder: '', own: [], drafts: [], examples: [] };
    /** @type {OpenFile | undefined} */
    this.file = undefined;
    this.choice = choice({ id: 'program-file', 'aria-label': 'Program' }, [], (value) =>
      room.attempt(() => this.choose(value)),
    );
    this.change = element('div', {});
    const make = button('New…', 'Makes another program', () => room.attempt(() => this.#make('')), {
      id: 'program-new',
    });
    this.saveButton = button('Save', 'Saves the program (Ctrl+S)', () => room.attempt(() => room.save()), {
      id: 'program-save',
    });
    room.bar.append(this.choice, make, this.saveButton);
    room.notes.append(this.change);
  }

  /** @returns {boolean} whether something is lost if the page is closed now */
  get isAtRisk() {
    return !this.#isDraftKept;
  }

  /** @param {ProgramList} list */
  async open(list) {
    this.list = list;
    const last = recall(KEY, '');
    const wanted = [last, list.drafts[0]?.path, list.own[0]?.path].find(
      (path) => path && [...list.own, ...list.drafts].some((each) => each.path === path),
    );
    if (wanted) {
      await this.openOwn(wanted);
    } else {
      const path = folderOfNew(list.own) + FIRST_NAME;
      this.#show(opened('own', path, await this.service.newProgram(path), ''), '');
    }
    if (!this.#looking) {
      this.#looking = true;
      setInterval(() => this.#look(), LOOK_MILLISECONDS);
    }
  }

  /** @param {string} path of one of the person's own programs */
  async openOwn(path) {
    const isSaved = this.list.own.some((each) => each.path === path);
    const isDraft = this.list.drafts.some((each) => each.path === path);
    const { text, version } = isSaved ? await this.service.read('own', path) : { text: '', version: '' };
    const draft = isDraft ? (await this.service.read('draft', path)).text : undefined;
    keep(KEY, path);
    this.#show(opened('own', path, text, version), normal(draft ?? text));
    if (draft !== undefined && normal(draft) !== normal(text)) {
      this.#say('This is what you had not saved.', [
        ['Take the saved one', () => this.#takeSaved()],
        ['Keep this', async () => this.#say('', [])],
      ]);
    }
  }

  /** Saves the program. @returns {Promise<boolean>} whether that was possible */
  async save() {
    const { file } = this;
    if (!file || file.shelf === 'example') {
      return false;
    }
    await this.#keepDraft();
    const text = this.editor.text;
    try {
      const version = await this.service.write(file.path, written(file, text), file.version);
      this.file = { ...file, saved: text, version };
      this.#isDraftKept = true;
      await this.refresh();
      return true;
    } catch (error) {
      if (/** @type {any} */ (error).status !== 409) {
        throw error;
      }
      this.#sayChanged(/** @type {Error} */ (error).message);
      return false;
    }
  }

  /** Something was typed. */
  changed() {
    const isWork = isUnsaved(this.file, this.editor.text);
    this.saveButton.disabled = !isWork;
    if (this.file?.shelf === 'own') {
      this.#isDraftKept = !isWork;
      clearTimeout(this.#draftTimer);
      this.#draftTimer = window.setTimeout(() => this.room.attempt(() => this.#keepDraft()), DRAFT_MILLISECONDS);
    }
  }

  async refresh() {
    this.list = await this.service.list();
    this.#draw();
  }

  async #keepDraft() {
    clearTimeout(this.#draftTimer);
    const { file } = this;
    const text = this.editor.text;
    if (file?.shelf !== 'own') {
      return;
    }
    if (isUnsaved(file, text)) {
      await this.service.writeDraft(file.path, written(file, text));
    } else if (this.list.drafts.some(({ path }) => path === file.path)) {
      await this.service.removeDraft(file.path);
    }
    this.#isDraftKept = text === this.editor.text;
  }

  /** @param {OpenFile} file @param {string} text of the editor, if it is another one than that of the file */
  #show(file, text) {
    this.file = file;
    const isExample = file.shelf === 'example';
    this.editor.open(`${file.shelf} ${file.path}`, text || file.saved, isExample);
    this.#isDraftKept = true;
    this.#say('', []);
    if (isExample) {
      this.#say('An example, which can only be read. Run makes a copy of your own.', [
        ['Make my own copy', () => this.#make(file.path)],
      ]);
    }
    this.#draw();
    this.room.opened();
  }

  #draw() {
    const { file, list } = this;
    fillChoice(this.choice, list, this.room.exercises.names, file);
    this.choice.value = file ? `${file.shelf} ${file.path}` : '';
    this.choice.title = `${list.folder}`;
    this.saveButton.disabled = !isUnsaved(file, this.editor.text);
    this.room.runs.draw();
  }

  /** @param {string} value the kind of program and its path or name, with a space between */
  async choose(value) {
    const [shelf, ...words] = value.split(' ');
    const path = words.join(' ');
    await this.#keepDraft();
    await this.refresh();
    if (shelf === 'example') {
      this.#show(opened('example', path, (await this.service.read('example', path)).text, ''), '');
    } else if (shelf === 'exercise') {
      await this.room.exercises.begin(path);
    } else {
      await this.openOwn(path);
    }
  }

  /** @param {string} example what to begin with, or nothing */
  async #make(example) {
    const folder = folderOfNew(this.list.own);
    const name = await ask({
      title: example ? 'Make my own copy' : 'New program',
      label: 'Name',
      value: this.#nameFor(example)
        .slice(folder.length)
        .replace(/\.java$/, ''),
      action: 'Make it',
      pattern: NAME,
      hint: NAME_HINT,
    });
    if (name) {
      await this.#create(folder + javaName(name), example);
    }
  }

  /** Makes a copy of the example that is shown, which can be changed and run. */
  async copyExample() {
    if (this.file?.shelf === 'example') {
      await this.#create(this.#nameFor(this.file.path), this.file.path);
    }
  }

  /** @param {string} example @returns {string} a free path for a program that begins with it */
  #nameFor(example) {
    const wanted = example ? `My${example.replace(/^Agent_/, '')}.java` : FIRST_NAME;
    return freeName(folderOfNew(this.list.own) + wanted, this.list.own);
  }

  /** @param {string} path @param {string} example */
  async #create(path, example) {
    await this.#keepDraft();
    await this.service.write(path, await this.service.newProgram(path, example), '');
    await this.refresh();
    await this.openOwn(path);
  }

  async #takeSaved() {
    const { file } = this;
    if (file) {
      const { text, version } = await this.service.read('own', file.path);
      this.file = opened('own', file.path, text, version);
      this.editor.replace(this.file.saved);
      this.#say('', []);
      await this.#keepDraft();
      this.#draw();
    }
  }

  /** @param {string} text */
  #sayChanged(text) {
    this.#say(text, [
      ['Take the other one', () => this.#takeSaved()],
      ['Keep mine', () => this.#keepMine()],
    ]);
  }

  async #keepMine() {
    const { file } = this;
    if (file) {
      const { version } = await this.service.read('own', file.path);
      this.file = { ...file, version };
      this.#say('', []);
      await this.room.save();
    }
  }

  /** Takes over what another program has written, unless there is unsaved work. */
  async #look() {
    if (document.hidden || byId('program-room').hidden) {
      return;
    }
    const { file } = this;
    try {
      const list = await this.service.list();
      const now = list.own.find((/** @type {{path: string}} */ { path }) => path === file?.path)?.version;
      const isOther = JSON.stringify(list) !== JSON.stringify(this.list);
      this.list = list;
      if (file && file === this.file && file.shelf === 'own' && now && now !== file.version) {
        await this.#takeOver(file);
      } else if (isOther && document.activeElement !== this.choice) {
        this.#draw();
      }
    } catch {
      // The studio has ended or begins again; the page says so elsewhere.
    }
  }

  /** @param {OpenFile} file */
  async #takeOver(file) {
    if (file.version !== '' && !isUnsaved(file, this.editor.text)) {
      await this.#takeSaved();
      await this.room.runs.saved();
    } else if (this.change.childElementCount === 0) {
      this.#sayChanged(`${fileName(file.path)} was changed by another program.`);
    }
  }

  /** @param {string} text @param {Array<[string, () => Promise<void>]>} deeds */
  #say(text, deeds) {
    const buttons = deeds.map(([name, deed]) => button(name, '', () => this.room.attempt(deed)));
    this.change.replaceChildren(...(text ? [note(text, ...buttons)] : []));
  }
}
