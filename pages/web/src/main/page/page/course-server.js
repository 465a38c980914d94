/** Local replacement for the course server: worksheets, the judge in the world's worker, and progress. */
import { CourseProgress } from './course-progress.js';
import { solutionOf } from './course-solutions.js';
import { storage } from './page-storage.js';

/**
 * @typedef {import('../state/course.js').Lesson} Lesson
 * @typedef {import('../state/course.js').Attempt} Attempt
 * @typedef {Lesson & {fullName: string, startCode: string, hints: string[]}} Sheet
 */

const LANGUAGE = 'robonewbie-page-language';

/** @type {Attempt} */
const NONE = {
  id: 0,
  state: 'NONE',
  exercise: '',
  program: '',
  port: 0,
  trials: 0,
  judged: [],
  points: 0,
  passed: false,
  output: '',
};

export class CourseServer {
  #repository;
  #programs;
  #progress = new CourseProgress();
  /** @type {Map<string, Promise<Sheet[]>>} */
  #sheets = new Map();
  /** @type {Promise<import('./course-progress.js').Badge[]> | undefined} */
  #badges;
  #language = storage().get(LANGUAGE) ?? 'en';
  /** @type {Attempt} */
  #attempt = NONE;
  /** @type {((refusal: string) => void) | undefined} */
  #resolveStart;
  /** Shows the free pitch again. */
  freePitch = () => {};

  /**
   * @param {import('./world-process.js').World} world
   * @param {import('./program-repository.js').ProgramRepository} repository
   * @param {import('./program-server.js').ProgramServer} programs
   */
  constructor(world, repository, programs) {
    this.world = world;
    this.#repository = repository;
    this.#programs = programs;
  }

  /** Called when another program has taken over the world. */
  forget() {
    this.#attempt = NONE;
  }

  /** @param {string} refusal why the program cannot be judged; empty if its trials are running */
  answered(refusal) {
    const resolveStart = this.#resolveStart;
    this.#resolveStart = undefined;
    resolveStart?.(refusal);
    return resolveStart !== undefined;
  }

  /** @param {string} text progress of the judge, a JSON object */
  receive(text) {
    if (text === '' || this.#attempt.state === 'NONE') {
      return;
    }
    const news = JSON.parse(text);
    const wasOver = this.#attempt.state === 'OVER';
    const sum = news.judged.reduce(
      (/** @type {number} */ points, /** @type {any} */ trial) => points + trial.points,
      0,
    );
    const isOver = news.state === 'OVER';
    this.#attempt = {
      ...this.#attempt,
      ...news,
      points: news.judged.length === 0 ? 0 : sum / news.judged.length,
      passed: isOver && news.judged.every((/** @type {{passed: boolean}} */ { passed }) => passed),
    };
    if (isOver && !wasOver) {
      this.#progress.tried(this.#attempt.exercise, this.#attempt.points, this.#attempt.passed);
    }
  }

  /** @param {string} place path after `course` @param {RequestInit} options @returns {Promise<Response>} */
  async answer(place, options) {
    const [path, search = ''] = place.split('?');
    const wish = new URLSearchParams(search);
    const [, name = '', help = ''] = path.split('/').map(decodeURIComponent);
    const method = options.method ?? 'GET';
    if (name === 'language') {
      this.#speak(wish.get('code') ?? '');
      return Response.json(await this.#overview());
    }
    if (name === '') {
      return Response.json(await this.#overview());
    }
    if (name === 'attempt') {
      return Response.json(method === 'DELETE' ? this.#leave() : this.#attempt);
    }
    const sheet = await this.#sheet(name);
    if (help !== '') {
      return Response.json(await this.#help(sheet, method === 'POST' ? help : ''));
    }
    if (method === 'PUT') {
      return Response.json(this.#createStarter(sheet));
    }
    if (method === 'POST') {
      await this.#begin(sheet, wish.get('program') ?? '', Number(wish.get('trials')));
    }
    return Response.json(this.#attempt);
  }

  /** @param {string} code */
  #speak(code) {
    this.#language = code;
    storage().set(LANGUAGE, code);
    this.world.postMessage({ language: code });
  }

  async #overview() {
    const sheets = await this.#all();
    this.#badges ??= fetch('course/badges.json').then((answer) => answer.json());
    const lessons = sheets.map(({ startCode: _, hints: __, ...lesson }) => ({
      ...lesson,
      standing: this.#progress.standing(lesson.name),
    }));
    return {
      language: this.#language,
      lessons,
      programs: this.#repository.own.map(({ path }) => path),
      standings: this.#progress.standings(lessons, await this.#badges),
    };
  }

  /** @returns {Promise<Sheet[]>} */
  #all() {
    const code = this.#language;
    const sheets = this.#sheets.get(code) ?? fetch(`course/${code}.json`).then((answer) => answer.json());
    this.#sheets.set(code, sheets);
    return sheets;
  }

  /** @param {string} name */
  async #sheet(name) {
    const sheet = (await this.#all()).find((each) => each.name === name);
    if (!sheet) {
      throw new Error(`There is no exercise "${name}".`);
    }
    return sheet;
  }

  /** @param {Sheet} sheet @param {string} wish `hint` or `solution`; empty to only read */
  async #help(sheet, wish) {
    const { name, hints } = sheet;
    const solution = await solutionOf(sheet);
    const triesLeft = this.#progress.triesBeforeSolution(name);
    if (wish === 'solution' && solution !== '' && triesLeft === 0) {
      this.#progress.seeSolution(name);
      return solution;
    }
    if (wish === 'hint') {
      this.#progress.openHint(name, hints.length);
    }
    return {
      hints: hints.slice(0, this.#progress.hints(name)),
      allHints: hints.length,
      solution: solution !== '',
      triesLeft,
    };
  }

  /** @param {Sheet} sheet @returns {string} path of the written file */
  #createStarter({ name, file, startCode }) {
    if (!this.#repository.add(file, startCode)) {
      throw new Error(`There is a file ${file} already, and it is kept. Rename it to start over.`);
    }
    this.#progress.seen(name);
    return file;
  }

  /** @param {Sheet} sheet @param {string} program @param {number} trials */
  async #begin({ name }, program, trials) {
    if (program === '') {
      throw new Error('This page only runs programs written in it: choose one.');
    }
    const classes = await this.#programs.compiled(program);
    const refusal = await new Promise((done) => {
      this.#resolveStart = done;
      this.world.postMessage({ exercise: { name, trials, classes, language: this.#language } });
    });
    if (refusal) {
      throw new Error(refusal);
    }
    this.#programs.forget();
    this.#attempt = { ...NONE, state: 'RUNNING', exercise: name, program, trials };
  }

  #leave() {
    if (this.#attempt.state !== 'NONE') {
      this.freePitch();
    }
    this.forget();
    return this.#attempt;
  }
}
