/** Exercises in the program room: the task above the program, and the Check button, which grades the editor's text. */
import { button, element, setText } from '../panels/elements.js';
import { checkText, hints, progressText, startingText, trialText } from '../state/course.js';
import { lessonOf } from '../state/program/documents.js';
import { note } from './note.js';

/**
 * @typedef {import('../state/course.js').Lesson} Lesson
 * @typedef {import('../state/course.js').Attempt} Attempt
 */

const LOOK_MILLISECONDS = 400;
const TRIALS = 3;

export class ExerciseController {
  #looking = false;
  #isShown = false;
  #isFast = false;
  /** State of the program being checked; empty if there is no attempt. */
  status = '';

  /** @param {any} room */
  constructor(room) {
    this.room = room;
    this.service = room.service;
    /** @type {Lesson[]} */
    this.lessons = [];
    this.place = element('div', {});
    room.notes.append(this.place);
    this.progress = element('p', { id: 'program-progress', role: 'status' });
    this.trials = element('ul', { id: 'program-trials' });
    this.hints = element('div', { id: 'program-hints' });
    const leave = button('Back to the free pitch', 'Ends the trial', () => room.attempt(() => this.leave()), {
      id: 'program-leave',
    });
    this.verdict = element('div', { hidden: '' }, this.progress, this.trials, this.hints, leave);
    room.said.verdict.append(this.verdict);
  }

  /** Name and title of each exercise, for the list of programs. */
  get names() {
    return this.lessons.map(({ name, number, title }) => `${name}\t${number} ${title}`);
  }

  /** @param {string} name @returns {boolean} whether there is an exercise with this name */
  has(name) {
    return this.lessons.some((each) => each.name === name);
  }

  async open() {
    this.lessons = await this.service.lessons();
  }

  /** Opens an exercise with its starter program or the existing solution. @param {string} name */
  async begin(name) {
    const { files } = this.room;
    const lesson = this.lessons.find((each) => each.name === name);
    const there = [...files.list.own, ...files.list.drafts].find(({ path }) => lessonOf(path, this.lessons) === lesson);
    const path = there?.path ?? (await this.service.createStarter(name));
    await files.refresh();
    await files.openOwn(path);
  }

  /** Shows the task of the exercise to which the open program belongs. */
  draw() {
    const { file } = this.room.files;
    const lesson = file?.kind === 'own' ? lessonOf(file.path, this.lessons) : undefined;
    if (!lesson) {
      this.place.replaceChildren();
      return;
    }
    const judge = button('Check', 'Saves the program and grades it', () => {
      this.room.attempt(() => this.check(lesson, TRIALS));
    });
    judge.id = 'program-check';
    const sheet = element('a', { href: lesson.worksheet, target: 'robonewbie-docs' }, 'Worksheet');
    this.place.replaceChildren(note(`Exercise ${lesson.number}: ${lesson.goal}`, sheet, judge));
  }

  /** Saves and grades the program. @param {{name: string}} lesson @param {number} trials */
  async check({ name }, trials) {
    if (!(await this.room.files.save())) {
      return;
    }
    await this.room.runs.stop();
    this.room.runs.forgetMistakes();
    this.#show(await this.service.attempt(name, this.room.files.file.path, trials));
    this.room.surroundings.goLive();
    this.#watch();
  }

  /** Ends a running trial and returns to free play. */
  async leave() {
    if (this.#isShown) {
      this.#show(await this.service.leaveAttempt());
      this.room.surroundings.goLive();
    }
  }

  async #watch() {
    if (this.#looking) {
      return;
    }
    this.#looking = true;
    while (this.#isShown) {
      await new Promise((done) => setTimeout(done, LOOK_MILLISECONDS));
      try {
        this.#show(await this.service.attemptNow());
      } catch {
        // The studio is down or restarting, which the connection banner reports.
      }
    }
    this.#looking = false;
  }

  /** @param {Attempt} attempt */
  #show(attempt) {
    this.#isShown = attempt.state !== 'NONE';
    this.verdict.hidden = this.room.firstMinute.receive(attempt) || !this.#isShown;
    this.status = checkText(attempt);
    this.room.surroundings.announce(startingText(attempt));
    this.#speedUp(attempt);
    this.room.runs.draw();
    setText(this.progress, progressText(attempt));
    this.trials.replaceChildren(
      ...attempt.judged.map((trial) => element('li', { 'data-passed': String(trial.passed) }, trialText(trial))),
    );
    this.hints.replaceChildren(...hints(attempt).map((hint) => element('p', {}, `Hint: ${hint}`)));
    if (this.#isShown) {
      this.room.said.showOutput(attempt.output);
    }
  }

  /** Runs the trials after the first one as fast as possible, and returns to real time after the last one. @param {Attempt} attempt */
  #speedUp({ state, judged }) {
    const isFast = judged.length > 0 && (state === 'WAITING' || state === 'RUNNING');
    if (isFast && !this.#isFast) {
      this.room.surroundings.send({ do: 'speed', factor: 'fastest' });
    }
    if (this.#isFast && state === 'OVER') {
      this.room.surroundings.send({ do: 'speed', factor: 1 });
    }
    this.#isFast = isFast;
  }
}
