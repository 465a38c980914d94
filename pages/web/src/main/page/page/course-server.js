/**
 * Local replacement for the course server: forwards requests to the course service in the world's worker, and stores its data in this
 * browser.
 */
import { answer } from '../live/server.js';
import { isAnswer, requestOf, responseOf } from './page-server.js';
import { storage } from './page-storage.js';

const LANGUAGE = 'robonewbie-page-language';
const PROGRESS = 'robonewbie-page-progress';

/** @typedef {Record<string, any>} States progress by exercise name */

export class CourseServer {
  #questions;
  #repository;
  #programs;
  /** Progress that the browser's storage cannot hold, kept until the page is closed. @type {States} */
  #unsaved = {};
  /** @type {unknown} */
  #failure;

  /**
   * @param {import('./world-questions.js').WorldQuestions} questions
   * @param {import('./program-repository.js').ProgramRepository} repository
   * @param {import('./program-server.js').ProgramServer} programs
   */
  constructor(questions, repository, programs) {
    this.#questions = questions;
    this.#repository = repository;
    this.#programs = programs;
  }

  /** @param {string} text the changed progress as a JSON object */
  keep(text) {
    Object.assign(this.#unsaved, JSON.parse(text).exercises);
    try {
      storage().set(PROGRESS, JSON.stringify(this.#progress));
      this.#unsaved = {};
    } catch {
      // Retried on the next change. Full storage is reported when a program is saved.
    }
  }

  /** @param {string} text path and text of a starter program as a JSON object */
  create(text) {
    const { path, text: program } = JSON.parse(text);
    try {
      this.#repository.add(path, program);
    } catch (full) {
      this.#failure = full;
    }
  }

  /** Request handlers. */
  get parts() {
    /** @type {import('./page-server.js').Part} */
    const served = (values, _, request) => this.#answer(requestOf(request, values));
    return {
      'GET course': served,
      'POST course/language': served,
      'GET course/attempt': served,
      'DELETE course/attempt': served,
      'PUT course/NAME': served,
      'POST course/NAME': served,
      'GET course/NAME/help': served,
      'POST course/NAME/hint': served,
      'POST course/NAME/solution': served,
    };
  }

  /** @param {import('./page-server.js').ServiceRequest} asked @returns {Promise<Response>} */
  async #answer(asked) {
    const { parameters } = asked;
    const path = asked.path.slice(1);
    const request = JSON.stringify({
      ...asked,
      path,
      language: storage().get(LANGUAGE) ?? 'en',
      progress: this.#progress,
      programs: this.#repository.own.map((each) => each.path),
      drafts: this.#repository.drafts.map((each) => each.path),
      solutions: path.length > 1 ? await this.#solutions(path[0]) : {},
    });
    const result = parameters.program
      ? await this.#begin(request, parameters.program)
      : await this.#questions.ask('answer', 'course', request);
    this.#throwFailure();
    const response = responseOf(result);
    if (parameters.code) {
      storage().set(LANGUAGE, parameters.code);
    }
    return response;
  }

  /** @param {string} request @param {string} path path of the program */
  async #begin(request, path) {
    const result = await this.#questions.begin(request, await this.#programs.compiled(path));
    if (isAnswer(result)) {
      this.#programs.forget();
    }
    return result;
  }

  #throwFailure() {
    const failure = this.#failure;
    this.#failure = undefined;
    if (failure) {
      throw failure;
    }
  }

  get #progress() {
    const { exercises } = migrated(JSON.parse(storage().get(PROGRESS) ?? '{}'));
    return { version: 1, exercises: { ...exercises, ...this.#unsaved } };
  }

  /**
   * Loads the solution of an exercise, if a teacher has put the folder `solutions` from the teachers' zip next to this page.
   *
   * @param {string} exercise
   * @returns {Promise<Record<string, string>>} text by file name
   */
  async #solutions(exercise) {
    const { lessons } = await answer('GET course');
    const { file = '' } = lessons.find((/** @type {{name: string}} */ { name }) => name === exercise) ?? {};
    const program = await solution(file);
    return {
      'locked.txt': (await solution('locked.txt')) ?? 'all',
      ...(program === undefined ? {} : { [file]: program }),
    };
  }
}

/** @param {string} file @returns {Promise<string | undefined>} its text; undefined if it cannot be loaded */
async function solution(file) {
  try {
    const answer = await fetch(`solutions/${file}`, { cache: 'no-cache' });
    return answer.ok ? await answer.text() : undefined;
  } catch {
    return undefined;
  }
}

/** Converts progress that was stored by earlier versions. @param {any} stored @returns {{exercises: States}} */
function migrated(stored) {
  if (stored.exercises) {
    return stored;
  }
  const states = Object.entries(stored).map(([name, { best, milliseconds, solution: seen, seenAt, ...state }]) => [
    name,
    {
      ...state,
      bestPoints: best,
      seconds: Math.floor(milliseconds / 1000),
      solutionSeen: seen ?? false,
      lastSeen: seenAt > 0 ? new Date(seenAt).toISOString() : '',
    },
  ]);
  return { exercises: Object.fromEntries(states) };
}
