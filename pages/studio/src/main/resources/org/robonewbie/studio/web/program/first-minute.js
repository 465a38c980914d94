/**
 * Tutorial for new users: three levels, which are displayed above the program and graded in the simulated world, and an arrow that points
 * to the next step.
 */
import { answer } from '../live/server.js';
import { button, element, setText } from '../panels/elements.js';
import { keep, recall } from '../panels/memory.js';
import { ghostOf, nextLevel, SKIPPED } from '../state/program/first-minute.js';
import { celebrate } from './confetti.js';
import { showGhost } from './ghost-text.js';

/**
 * @typedef {import('../state/program/first-minute.js').Level} Level
 * @typedef {import('../state/program/first-minute.js').Course} Course
 * @typedef {'edit' | 'run' | 'watch' | 'passed' | 'failed' | 'broken'} Step what to do or see now
 * @typedef {import('../state/course.js').Attempt} Attempt
 */

/** The first robot on an empty pitch. */
const PUPPET = { side: 'left', number: 1 };
const LOOK_MILLISECONDS = 300;

export class FirstMinute {
  /** @type {Course} */
  #course = { language: 'en', lessons: [] };
  /** @type {Level | undefined} */
  #level;
  /** @type {Attempt | undefined} */
  #attempt;
  /** Text of the most recently tried program. */
  #tried = '';
  #isBroken = false;
  #hasPuppet = false;

  /** @param {any} room */
  constructor(room) {
    this.room = room;
    const control = (/** @type {() => Promise<void>} */ action, /** @type {Record<string, string>} */ attributes) =>
      button('', '', () => room.attempt(action), attributes);
    this.count = element('span', { class: 'first-minute-count' });
    this.title = element('h2', { id: 'first-minute-title' });
    this.speak = control(() => this.#speak(), { class: 'quiet', id: 'first-minute-language' });
    this.skip = control(() => this.#leave(), { class: 'quiet', id: 'first-minute-skip' });
    this.goal = element('p', {});
    this.status = element('p', { role: 'status' });
    this.next = control(() => this.#goOn(), { class: 'primary first-minute-here', id: 'first-minute-next' });
    const head = element('div', { class: 'first-minute-head' }, this.count, this.title, this.speak, this.skip);
    const foot = element('div', { class: 'first-minute-foot' }, this.status, this.next);
    const named = { id: 'first-minute', 'aria-labelledby': this.title.id, hidden: '' };
    this.place = element('section', named, head, this.goal, foot);
    room.notes.prepend(this.place);
  }

  /** Opens the next level for a newcomer. */
  async open() {
    if (!recall(SKIPPED, false)) {
      this.#course = await answer('GET course');
      const level = nextLevel(this.#course, this.room.files.list);
      if (level) {
        await this.#begin(level);
        this.#addPuppet();
      }
    }
  }

  /** Called when another program is shown. */
  opened() {
    const level = this.#shownLevel;
    showGhost(this.room.editor.view, level);
    this.draw();
    if (level) {
      (this.#step(level) === 'passed' ? this.next : this.room.editor.view).focus();
    }
  }

  /** Shows what to do next. Call after each change to the program. */
  draw() {
    const level = this.#shownLevel;
    const step = level && this.#step(level);
    this.place.hidden = !level;
    this.room.runs.start.classList.toggle('first-minute-here', step === 'run');
    const { firstMinute, language } = this.#course;
    if (!level || !step || !firstMinute) {
      return;
    }
    const { levels, words } = firstMinute;
    const number = levels.indexOf(level) + 1;
    this.place.lang = language;
    setText(this.count, `${words.level} ${number} / ${levels.length}`);
    setText(this.title, level.title);
    setText(this.goal, level.goal);
    setText(this.speak, language === 'en' ? 'Deutsch' : 'English');
    this.speak.lang = language === 'en' ? 'de' : 'en';
    setText(this.skip, words.skip);
    this.skip.title = words.skipHint;
    setText(this.next, number < levels.length ? words.next : words.finish);
    this.next.hidden = !level.passed || step === 'watch';
    this.status.dataset.step = step;
    this.#showStatus(words[step], this.#detail(step, level));
  }

  /**
   * Tries the open program if it belongs to the level.
   *
   * @returns {Promise<boolean>} whether it does
   */
  async run() {
    const level = this.#shownLevel;
    if (!level) {
      return false;
    }
    const { editor, exercises, files, service } = this.room;
    this.#tried = editor.text;
    const remarks = await service.check(files.file.path, this.#tried);
    this.#isBroken = remarks.some((/** @type {{serious: boolean}} */ { serious }) => serious);
    if (!this.#isBroken) {
      await exercises.check(level, 1);
    }
    this.draw();
    return true;
  }

  /** @param {Attempt} attempt @returns {boolean} whether it is an attempt at a level */
  receive(attempt) {
    const level = this.#course.firstMinute?.levels.find(({ name }) => name === attempt.exercise);
    if (level && level === this.#level) {
      const before = this.#step(level);
      this.#attempt = attempt;
      level.passed ||= attempt.passed;
      this.draw();
      if (this.#step(level) === 'passed' && before !== 'passed') {
        showGhost(this.room.editor.view, undefined);
        this.next.focus();
        celebrate();
      }
    }
    return level !== undefined;
  }

  /** The current level if its program is open. */
  get #shownLevel() {
    return this.room.files.file?.path === this.#level?.file ? this.#level : undefined;
  }

  /** @param {Level} level @returns {Step} */
  #step(level) {
    const { text } = this.room.editor;
    const { state = 'NONE', passed = false } = this.#attempt ?? {};
    if (state === 'WAITING' || state === 'RUNNING') {
      return 'watch';
    }
    if (text === this.#tried && (this.#isBroken || state === 'OVER')) {
      return this.#isBroken ? 'broken' : passed ? 'passed' : 'failed';
    }
    return ghostOf(text, level) ? 'edit' : 'run';
  }

  /** @param {Step} step @param {Level} level @returns {string | Node} */
  #detail(step, level) {
    const { finding = '', hint = '' } = this.#attempt?.judged[0] ?? {};
    switch (step) {
      case 'edit':
        return element('code', {}, ghostOf(this.room.editor.text, level)?.line ?? '');
      case 'passed':
        return `${finding}.`;
      case 'failed':
        return `${finding}. ${hint}`;
      default:
        return '';
    }
  }

  /** Announces a change only once. @param {string} words @param {string | Node} detail */
  #showStatus(words, detail) {
    const text = typeof detail === 'string' ? detail : detail.textContent;
    if (this.status.textContent !== `${words} ${text}`) {
      this.status.replaceChildren(`${words} `, detail);
    }
  }

  /** @param {Level} level */
  async #begin(level) {
    this.#level = level;
    this.#attempt = undefined;
    this.#tried = '';
    this.#isBroken = false;
    await this.room.files.begin(level.file, level.start);
  }

  /** Continues with the next level, or with the exercises after the last one. */
  async #goOn() {
    const { levels = [] } = this.#course.firstMinute ?? {};
    const next = this.#level && levels[levels.indexOf(this.#level) + 1];
    if (next) {
      await this.#begin(next);
    } else {
      await this.#end();
      await this.room.exercises.begin(this.#course.lessons[0].name);
    }
  }

  async #leave() {
    keep(SKIPPED, true);
    await this.#end();
    await this.room.files.open(await this.room.service.list());
  }

  async #end() {
    this.#level = undefined;
    this.draw();
    await this.room.exercises.leave();
    if (this.#hasPuppet) {
      this.room.surroundings.send({ do: 'removePuppet', ...PUPPET });
    }
  }

  /** Switches to the other language. */
  async #speak() {
    const code = this.#course.language === 'en' ? 'de' : 'en';
    const index = this.#course.firstMinute?.levels.findIndex((level) => level === this.#level) ?? 0;
    this.#course = await answer('POST course/language', { code });
    this.#level = this.#course.firstMinute?.levels[index];
    await this.room.exercises.open();
    this.opened();
  }

  /** Adds a robot to an empty pitch as soon as the state of the pitch is known. */
  #addPuppet() {
    const { robots, isPitchEmpty, send } = this.room.surroundings;
    const timer = setInterval(() => {
      this.#hasPuppet = robots().some((/** @type {{puppet: boolean}} */ { puppet }) => puppet); // added before a reload
      if (isPitchEmpty() && this.#level && !this.#attempt) {
        this.#hasPuppet = true;
        send({ do: 'addPuppet', side: PUPPET.side });
      }
      if (this.#hasPuppet || robots().length > 0 || !this.#level) {
        clearInterval(timer);
      }
    }, LOOK_MILLISECONDS);
  }
}
