/** Model of the motion editor: holds the state and connects it to files, drafts and trials. Independent of rendering. */
import { keepText, recallText } from '../panels/memory.js';
import { Drafts, namelessDrafts } from './drafts.js';
import { judgeDisk } from '../state/motion/disk.js';
import { bodyMarks, jointMarks } from '../state/motion/checks.js';
import {
  documentOf,
  edited,
  framesOf,
  initialEditor,
  lengthOf,
  played,
  selected,
  withFile,
  withSaved,
} from '../state/motion/editor-state.js';
import { withInserted } from '../state/motion/motion-document.js';
import { composedName } from '../state/file-name.js';
import { EMPTY_DOCUMENT, emptyDocument, problemOf, textOf } from '../state/motion/motion-text.js';
import { asOriginal, hasSkippedKeyframes, isUndescribed } from '../state/motion/original-rule.js';
import { readPostures, withPosture } from '../state/motion/poses.js';
import { lagOf } from '../state/motion/lag.js';

/**
 * @typedef {import('../state/motion/editor-state.js').EditorState} EditorState
 * @typedef {import('../state/motion/checks.js').Mark} Mark
 * @typedef {import('../state/motion/poses.js').NamedPosture} NamedPosture
 * @typedef {import('./motion-files.js').MotionFiles} MotionFiles
 * @typedef {import('./motion-files.js').MotionList} MotionList
 */

const MARKS_MILLISECONDS = 120;
const MAX_TRIAL = 60_000;
const LAST_FILE = 'robonewbie-motion';

export class Editor {
  /**
   * @param {import('../state/motion/body.js').Body} body
   * @param {MotionFiles} files
   * @param {object} listener
   * @param {() => void} listener.changed requests a redraw
   * @param {(text: string) => void} listener.note
   */
  constructor(body, files, listener) {
    this.state = initialEditor(body);
    this.files = files;
    this.listener = listener;
    this.drafts = this.#makeDrafts();
    /** @type {MotionList} */
    this.list = { folder: '', own: [], drafts: [], library: [], leftOut: [] };
    /** @type {import('../state/motion/edits.js').Clip} */
    this.clip = { frames: [], rows: [] };
    /** @type {NamedPosture[]} */
    this.postures = [];
    /** @type {Mark[]} */
    this.marks = [];
    /** @type {import('../state/motion/lag.js').Lag | undefined} */
    this.lag = undefined;
    /** Whether the file has changed both on the disk and here, so the user must choose a version. */
    this.conflict = false;
    /** Whether the motion seems to have been written for the playback rule of RoboNewbie 1.1, so the user must choose the rule. */
    this.isOriginal = false;
    this.busy = false;
    /** Whether the file is being written. */
    this.saving = false;
    /** @type {Promise<void>} */
    this.lastSave = Promise.resolve();
    /** Number of requests to open a motion; replies to all but the latest are ignored. */
    this.requests = 0;
    this.marksTimer = 0;
  }

  #makeDrafts() {
    return new Drafts(this.files, {
      state: () => this.state,
      list: () => this.list,
      named: async (draft) => {
        if (this.state.name === '' && this.state.draft === '') {
          this.state = { ...this.state, draft };
        }
        await this.refresh();
      },
      note: this.listener.note,
    });
  }

  /** @param {EditorState} state */
  set(state) {
    const before = this.state;
    this.state = state;
    if (state.body !== before.body) {
      this.clip = { frames: [], rows: [] };
    }
    if (state.trial !== before.trial) {
      this.lag = state.trial && lagOf(state.body, framesOf(state), state.trial);
    }
    if (state.history !== before.history || state.saved !== before.saved) {
      this.drafts.keepSoon();
    }
    if (state.history.present !== before.history.present || state.manner !== before.manner) {
      clearTimeout(this.marksTimer);
      this.marksTimer = window.setTimeout(() => this.#check(), MARKS_MILLISECONDS);
    }
    this.listener.changed();
  }

  /** @param {(state: EditorState) => EditorState} edit */
  apply(edit) {
    this.set(edit(this.state));
  }

  /** @param {string} [wanted] the motion to open first */
  async begin(wanted) {
    await this.refresh();
    this.postures = readPostures(await this.files.postures());
    if (this.requests > 0) {
      return;
    }
    const last = composedName(wanted ?? recallText(LAST_FILE) ?? '');
    const isOwn = this.list.own.some(({ name }) => name === last);
    const drafts = namelessDrafts(this.list);
    if (drafts.length > 0 && !isOwn) {
      await this.#recover(drafts.includes(last) ? last : drafts[drafts.length - 1]);
    } else if (isOwn || this.list.library.includes(last)) {
      await this.#openFirst(isOwn ? 'motions' : 'library', last);
    } else {
      await this.open('library', 'wave');
    }
  }

  /**
   * Opens a motion; an unreadable file does not prevent the room from opening.
   *
   * @param {'motions' | 'library'} collection
   * @param {string} name
   */
  async #openFirst(collection, name) {
    try {
      await this.open(collection, name);
    } catch (error) {
      await this.open('library', 'wave');
      this.listener.note(/** @type {Error} */ (error).message);
    }
  }

  /** Whether closing the page would lose work. */
  get isAtRisk() {
    return this.drafts.isAtRisk(this.state);
  }

  async refresh() {
    this.list = await this.files.list();
    this.listener.changed();
  }

  /** Checks whether another program has changed the open file. */
  async lookAtDisk() {
    const { name, version } = this.state;
    await this.refresh();
    const isSame = this.state.name === name && this.state.version === version;
    const verdict = isSame && !this.saving ? judgeDisk(this.state, this.list.own) : 'same';
    this.conflict = verdict === 'ask';
    if (verdict === 'reload') {
      await this.reload();
      this.listener.note(`“${name}” was changed by another program and has been reloaded.`);
    } else if (verdict === 'gone') {
      this.listener.note(`“${name}” is no longer in the folder. Save to create it again.`);
      this.set({ ...this.state, version: '', saved: EMPTY_DOCUMENT });
    }
  }

  /** Reloads the file from the disk; undo restores the previous content. */
  async reload() {
    const request = this.requests;
    const { document, version, body } = await this.files.read('motions', this.state.name);
    if (request !== this.requests) {
      return;
    }
    this.conflict = false;
    if (body !== this.state.body) {
      this.set(withFile(this.state, { name: this.state.name, version, body, document }));
      return;
    }
    const taken = edited(this.state, document, 'Reload from disk');
    this.set(selected({ ...taken, version, saved: document }, this.state.last));
  }

  /** Keeps the editor's content; the next save replaces the file. */
  keepMine() {
    const known = this.list.own.find(({ name }) => name === this.state.name);
    this.conflict = false;
    this.set({ ...this.state, version: known?.version ?? '' });
  }

  /**
   * @param {'motions' | 'library'} collection
   * @param {string} name
   */
  async open(collection, name) {
    const request = ++this.requests;
    if (!(await this.drafts.keep())) {
      return;
    }
    const { document, version, body } = await this.files.read(collection, name);
    const isOwn = collection === 'motions';
    const draft = this.list.drafts.some((each) => each.name === name)
      ? (await this.files.read('drafts', name)).document
      : undefined;
    const isNew = draft !== undefined && textOf(draft) !== textOf(document);
    if (request !== this.requests) {
      return;
    }
    this.conflict = false;
    this.isOriginal = isOwn && body.isNao && isUndescribed(document) && hasSkippedKeyframes(document);
    const recovered = isNew ? draft : undefined;
    this.drafts.kept = recovered;
    this.set(withFile(this.state, { name, version: isOwn ? version : '', body, document, recovered }));
    keepText(LAST_FILE, name);
    if (isNew) {
      this.listener.note(`Unsaved work on “${name}” was recovered. Undo discards it.`);
    }
  }

  /** Creates a motion with a single keyframe: the standing posture. It is for the robot of the open motion. */
  async create() {
    const { body, start } = this.state;
    await this.#begin(withInserted(emptyDocument(body.robot), 0, { millis: 500, degrees: start }), body);
  }

  /**
   * Opens an imported motion, which is for the NAO.
   *
   * @param {import('../state/motion/motion-text.js').MotionDocument} document
   * @param {string} name name of the file
   * @param {readonly string[]} notes remarks about the import
   */
  async take(document, name, notes) {
    await this.#begin(document, await this.files.body(), await this.drafts.newName());
    const taken = `Keyframes imported from ${name}: ${framesOf(this.state).length}.`;
    this.listener.note([taken, ...notes, 'Save the motion under a new name.'].join(' '));
    const request = this.requests;
    const isOriginal = isUndescribed(document) && (await this.#isMadeForOriginal(document));
    if (request === this.requests) {
      this.isOriginal = isOriginal;
      this.listener.changed();
    }
  }

  /**
   * Returns whether a motion makes the robot fall under the current playback rule, but not under that of RoboNewbie 1.1.
   *
   * @param {import('../state/motion/motion-text.js').MotionDocument} document
   */
  async #isMadeForOriginal(document) {
    if (hasSkippedKeyframes(document)) {
      return true;
    }
    if (problemOf(document) !== '' || lengthOf(this.state) > MAX_TRIAL) {
      return false;
    }
    const now = await this.files.trial(document, 'standing');
    const then = now.fallSeconds === undefined ? now : await this.files.trial(asOriginal(document), 'standing');
    return then.fallSeconds === undefined && now.fallSeconds !== undefined;
  }

  /** Sets whether agents play the motion according to the rule of RoboNewbie 1.1. @param {boolean} isOriginal */
  decideRule(isOriginal) {
    this.isOriginal = false;
    const document = asOriginal(documentOf(this.state));
    this.set(isOriginal ? edited(this.state, document, 'Play as RoboNewbie 1.1') : { ...this.state });
  }

  /**
   * Saves the motion. Saves are serialised, because each save requires the version written by the previous one.
   *
   * @param {string} [asName] new name of the file
   * @returns {Promise<void>}
   */
  save(asName) {
    this.lastSave = this.lastSave.catch(() => {}).then(() => this.#save(asName));
    return this.lastSave;
  }

  /** @param {string} [asName] */
  async #save(asName) {
    const name = asName ?? this.state.name;
    const document = documentOf(this.state);
    const known = asName === undefined || asName === this.state.name ? this.state.version : '';
    const nameBefore = this.state.name || this.state.draft || name;
    const request = this.requests;
    this.saving = true;
    try {
      const version = await this.files.write(name, document, known);
      if (request === this.requests) {
        this.conflict = false;
        this.set(withSaved(this.state, name, version, document));
        keepText(LAST_FILE, name);
      }
    } finally {
      this.saving = false;
    }
    await Promise.all([...new Set([nameBefore, name])].map((each) => this.files.removeDraft(each)));
    await this.refresh();
    const hides = this.list.library.includes(name) ? '; it replaces the library motion with that name' : '';
    const plays = this.state.body.isNao ? ` An agent plays it with motions.start("${name}")${hides}.` : '';
    this.listener.note(`Saved.${plays}`);
  }

  /** @param {string} name @param {readonly number[]} degrees */
  async keepPosture(name, degrees) {
    const text = withPosture(await this.files.postures(), { name, degrees });
    await this.files.writePostures(text);
    this.postures = readPostures(text);
    this.listener.changed();
  }

  /** @param {number} millis */
  advance(millis) {
    if (this.state.playing) {
      this.set(played(this.state, millis));
    }
  }

  /**
   * Opens a document that has no name yet.
   *
   * @param {import('../state/motion/motion-text.js').MotionDocument} document
   * @param {import('../state/motion/body.js').Body} body the robot that the motion is for
   * @param {string} [draft] its name among the drafts, if it must be stored immediately
   */
  async #begin(document, body, draft = '') {
    const request = ++this.requests;
    if ((await this.drafts.keep()) && request === this.requests) {
      this.isOriginal = false;
      this.set(withFile(this.state, { name: '', draft, version: '', body, document }));
    }
  }

  /** Opens the draft of an untitled motion. @param {string} draft */
  async openDraft(draft) {
    const request = ++this.requests;
    const isKept = await this.drafts.keep();
    const { document, body } = await this.files.read('drafts', draft);
    if (isKept && request === this.requests) {
      this.conflict = false;
      this.isOriginal = false;
      this.drafts.kept = document;
      this.set(withFile(this.state, { name: '', draft, version: '', body, document }));
      keepText(LAST_FILE, draft);
    }
  }

  /** @param {string} draft */
  async #recover(draft) {
    await this.openDraft(draft);
    this.listener.note('Your unsaved new motion was recovered.');
  }

  #check() {
    const frames = framesOf(this.state);
    this.marks = [...jointMarks(this.state.body, frames), ...bodyMarks(this.state.body, frames, this.state.manner)];
    this.listener.changed();
  }
}
