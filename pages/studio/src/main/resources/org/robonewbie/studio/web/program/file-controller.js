/** Manages the open program: selects, opens, creates and saves it; keeps drafts; picks up changes made in an IDE. */
import { button, byId, choice, element } from '../panels/elements.js';
import { keep, recall } from '../panels/memory.js';
import { encodeText, encodingFor, UTF_8 } from '../state/decoded-text.js';
import {
  FIRST_NAME,
  folderOfNew,
  freeName,
  isOpenToChange,
  isUnsaved,
  LAST_PROGRAM,
  newText,
  normal,
  opened,
  written,
} from '../state/program/documents.js';
import { fileName } from '../state/program/remarks.js';
import { DraftKeeper } from './draft-keeper.js';
import { EncodingNote } from './encoding-note.js';
import { fillChoice } from './file-choice.js';
import { makeProgram } from './new-program.js';
import { note } from './note.js';

/**
 * @typedef {import('./program-service.js').ProgramList} ProgramList
 * @typedef {import('../state/program/documents.js').OpenFile} OpenFile
 */

const LOOK_MILLISECONDS = 1000;

export class FileController {
  #isPolling = false;
  /** Original text of the most recently opened shared program. */
  #asShared = '';
  #sharedVersion = '';

  /** @param {any} room */
  constructor(room) {
    this.room = room;
    this.service = room.service;
    this.editor = room.editor;
    this.drafts = new DraftKeeper(
      this,
      (action) => room.attempt(action),
      () => this.#showDraftConflict(),
    );
    /** @type {ProgramList} */
    this.list = { open: true, folder: '', own: [], drafts: [], examples: [] };
    /** @type {OpenFile | undefined} */
    this.file = undefined;
    this.choice = choice({ id: 'program-file', 'aria-label': 'Program' }, [], (value) =>
      room.attempt(() => this.choose(value)),
    );
    this.change = element('div', {});
    this.encoding = new EncodingNote((file) => room.attempt(() => this.#toUtf8(file)));
    const make = button('New…', 'Creates a program', () => room.attempt(() => makeProgram(this, '')), {
      id: 'program-new',
    });
    this.saveButton = button('Save', 'Saves the program (Ctrl+S)', () => room.attempt(() => room.save()), {
      id: 'program-save',
    });
    room.bar.append(this.choice, make, this.saveButton);
    room.notes.append(this.change, this.encoding.place);
  }

  /** @returns {boolean} whether closing the page would lose work */
  get isAtRisk() {
    return this.drafts.isAtRisk;
  }

  /** @param {ProgramList} list */
  async open(list) {
    this.list = list;
    const { first } = list;
    const last = recall(LAST_PROGRAM, '');
    const wanted = [first?.path, last, list.drafts[0]?.path, list.own[0]?.path].find(
      (path) => path && [...list.own, ...list.drafts].some((each) => each.path === path),
    );
    if (wanted && (!first || wanted === first.path)) {
      await this.openOwn(wanted);
    } else {
      const path = first?.path ?? folderOfNew(list.own) + FIRST_NAME;
      this.#show(opened('own', path, newText(await this.service.newProgram(path, first?.example))), '');
    }
    if (!this.#isPolling) {
      this.#isPolling = true;
      setInterval(() => this.#look(), LOOK_MILLISECONDS);
    }
  }

  /** @param {string} path path of one of the user's programs */
  async openOwn(path) {
    const isSaved = this.list.own.some((each) => each.path === path);
    const isDraft = this.list.drafts.some((each) => each.path === path);
    const file = opened('own', path, isSaved ? await this.service.read('own', path) : newText(''));
    const draft = isDraft && file.problem === '' ? await this.service.read('draft', path) : newText('');
    keep(LAST_PROGRAM, path);
    this.#show(file, normal(draft.text.content));
    this.drafts.begin(draft.version);
    const shared = this.list.shared?.find((each) => each.path === path);
    if (shared) {
      this.#asShared = this.editor.text;
      this.#sharedVersion = draft.version;
      this.#showNote('This program was shared with you. Your own programs have not been changed.', [
        ['Keep a copy', () => this.room.save()],
        ['Back to my program', () => this.#discardShared(shared)],
      ]);
    } else if (isSaved && draft.version !== '' && normal(draft.text.content) !== file.saved) {
      this.#showNote('This is your unsaved draft.', [
        ['Use the saved version', () => this.#takeSaved()],
        ['Keep the draft', async () => this.#showNote('', [])],
      ]);
    }
  }

  /** Opens a program, which starts with the given text if it is new. @param {string} path @param {string} text */
  async begin(path, text) {
    if (this.isAtRisk && !(await this.drafts.keep())) {
      return;
    }
    await this.refresh();
    if ([...this.list.own, ...this.list.drafts].some((each) => each.path === path)) {
      await this.openOwn(path);
    } else {
      this.#show(opened('own', path, newText(text)), '');
    }
  }

  /** Saves the program. @returns {Promise<boolean>} whether it succeeded */
  async save() {
    const { file } = this;
    if (!file || !isOpenToChange(file)) {
      return false;
    }
    await this.drafts.keep().catch(() => false); // the text can be saved even without a draft
    const content = written(file, this.editor.text);
    const encoding = encodingFor(file.source, content);
    try {
      const version = await this.service.write(file.path, encodeText(file.source, content), file.version);
      const text = { ...file.source, encoding, content };
      this.file = opened('own', file.path, { text, version, problem: '' });
      this.drafts.saved();
      this.room.history.keep(file, this.file.saved);
      if (file.version === '') {
        this.#showNote('', []);
      }
      this.encoding.show(this.file, file.source.encoding);
      await this.refresh();
      return true;
    } catch (error) {
      if (/** @type {any} */ (error).status !== 409) {
        throw error;
      }
      this.#showFileConflict(/** @type {Error} */ (error).message);
      return false;
    }
  }

  /** Called when the text has changed. */
  changed() {
    this.saveButton.disabled = !isUnsaved(this.file, this.editor.text);
    if (isOpenToChange(this.file)) {
      this.drafts.keepSoon();
    }
  }

  async refresh() {
    this.list = await this.service.list();
    this.#draw();
  }

  /** @param {OpenFile} file @param {string} text the editor's text, if it differs from the file */
  #show(file, text) {
    this.file = file;
    const isExample = file.kind === 'example';
    const isReadOnly = !isOpenToChange(file);
    const kind = isReadOnly ? `${file.kind}, read-only` : file.kind;
    this.editor.open(`${kind} ${file.path}`, text || file.saved, isReadOnly);
    this.encoding.show(file, file.source.encoding);
    this.drafts.begin('');
    this.#showNote('', []);
    if (isExample) {
      this.#showNote('This example is read-only. Run creates your own copy.', [
        ['Make my own copy', () => makeProgram(this, file.path)],
      ]);
    }
    this.#draw();
    this.room.opened();
  }

  #draw() {
    const { file, list } = this;
    fillChoice(this.choice, list, this.room.exercises.names, file);
    this.choice.value = file ? `${file.kind} ${file.path}` : '';
    this.choice.title = `${list.folder}`;
    this.saveButton.disabled = !isUnsaved(file, this.editor.text);
    this.room.runs.draw();
    this.room.history.draw();
  }

  /** @param {string} value kind of program and its path or name, separated by a space */
  async choose(value) {
    const [kind, ...words] = value.split(' ');
    const path = words.join(' ');
    if (!(await this.drafts.keep())) {
      this.#draw();
      return;
    }
    await this.refresh();
    if (kind === 'example') {
      this.#show(opened('example', path, await this.service.read('example', path)), '');
    } else if (kind === 'exercise') {
      await this.room.exercises.begin(path);
    } else {
      await this.openOwn(path);
    }
  }

  async #takeSaved() {
    const { file } = this;
    if (file) {
      const now = opened('own', file.path, await this.service.read('own', file.path));
      if (now.problem !== file.problem) {
        this.#show(now, '');
        return;
      }
      this.file = now;
      this.editor.replace(now.saved);
      this.encoding.show(now, now.source.encoding);
      this.#showNote('', []);
      await this.drafts.keep();
      this.#draw();
    }
  }

  /** @param {OpenFile} file */
  async #toUtf8(file) {
    this.file = { ...file, source: UTF_8 };
    await this.room.save();
  }

  /**
   * Discards the shared program unless it has been changed, and opens the previous one, else another one of the user, else a new one.
   *
   * @param {{path: string, before: string}} shared
   */
  async #discardShared({ path, before }) {
    if (this.editor.text === this.#asShared) {
      await this.service.removeDraft(path, this.#sharedVersion);
    } else {
      await this.drafts.keep();
    }
    this.drafts.begin('');
    const { own, drafts } = await this.service.list();
    const others = [...own, ...drafts].filter((each) => each.path !== path);
    const found = others.find((each) => each.path === before) ?? others[0];
    const name = found?.path ?? freeName(FIRST_NAME, [{ path }]);
    await this.begin(name, found ? '' : await this.service.newProgram(name));
  }

  /** Reports that another window has unsaved changes to the open file. */
  #showDraftConflict() {
    const { path = '' } = this.file ?? {};
    this.#showNote(`Another window also has unsaved changes to ${fileName(path)}.`, [
      ['Use the other version', () => this.#takeDraft(path)],
      ['Keep mine', () => this.#replaceDraft(path)],
    ]);
  }

  /** @param {string} path */
  async #takeDraft(path) {
    const { text, version } = await this.service.read('draft', path);
    this.drafts.replace(version);
    this.editor.replace(normal(text.content));
    this.#showNote('', []);
    await this.drafts.keep();
  }

  /** @param {string} path */
  async #replaceDraft(path) {
    this.drafts.replace((await this.service.read('draft', path)).version);
    this.#showNote('', []);
    await this.drafts.keep();
  }

  /** @param {string} text */
  #showFileConflict(text) {
    this.#showNote(text, [
      ['Use the other version', () => this.#takeSaved()],
      ['Keep mine', () => this.#keepMine()],
    ]);
  }

  async #keepMine() {
    const { file } = this;
    if (file) {
      const gone = { version: '' };
      const { version } = await this.service.read('own', file.path).catch(() => gone);
      this.file = { ...file, version };
      this.#showNote('', []);
      await this.room.save();
    }
  }

  /** Opens the program of another run, or reloads the file if another program has written it and there are no unsaved changes. */
  async #look() {
    if (document.hidden || byId('program-room').hidden) {
      return;
    }
    const { file } = this;
    try {
      const list = await this.service.list();
      if (list.first && list.first.path !== this.list.first?.path && (await this.drafts.keep())) {
        await this.open(list);
        await this.room.runs.look();
      } else {
        await this.#take(list, file);
      }
    } catch {
      // The studio is down or restarting, which the connection banner reports.
    }
  }

  /**
   * @param {ProgramList} list the current list of files @param {OpenFile | undefined} file the file that was open before the list was read
   */
  async #take(list, file) {
    const now = list.own.find(({ path }) => path === file?.path)?.version;
    const isOther = JSON.stringify(list) !== JSON.stringify(this.list);
    this.list = list;
    if (file && file === this.file && file.kind === 'own' && now && now !== file.version) {
      await this.#reloadChanged(file);
    } else if (isOther && document.activeElement !== this.choice) {
      this.#draw();
    }
  }

  /** @param {OpenFile} file */
  async #reloadChanged(file) {
    if (file.version !== '' && !isUnsaved(file, this.editor.text)) {
      await this.#takeSaved();
      await this.room.runs.saved();
    } else if (this.change.childElementCount === 0) {
      this.#showFileConflict(`${fileName(file.path)} was changed by another program.`);
    }
  }

  /** @param {string} text @param {Array<[string, () => Promise<void>]>} actions */
  #showNote(text, actions) {
    const buttons = actions.map(([name, action]) => button(name, '', () => this.room.attempt(action)));
    this.change.replaceChildren(...(text ? [note(text, ...buttons)] : []));
  }
}
