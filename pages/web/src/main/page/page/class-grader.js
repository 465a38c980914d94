/** Grades the programs of a class one after the other, with this page's compiler and judge. */
import { ClassWorker } from './class-worker.js';
import { PageCompiler } from './page-compiler.js';
import { withReferences } from './project.js';

/**
 * @typedef {import('./class-worker.js').Judged} Judged
 * @typedef {{student: string, exercise: string, file: string, files: Record<string, string>}} Program
 * @typedef {{student: string, exercise: string} & ({judged: Judged[]} | {reason: string})} Mark
 */

const MOTION = /^motions\/(.*)\.txt$/;

/** @param {Record<string, string>} files @returns {[string, Int8Array][]} name and bytes of each motion */
const motionsOf = (files) =>
  Object.entries(files).flatMap(([path, text]) => {
    const [, name] = MOTION.exec(path) ?? [];
    return name ? [[name, new Int8Array(new TextEncoder().encode(text).buffer)]] : [];
  });

export class ClassGrader {
  #compiler = new PageCompiler(() => {});
  /** Grades by program content, so that no program is graded twice. @type {Map<string, Mark>} */
  #known = new Map();
  /** @type {ClassWorker | undefined} */
  #worker;
  #isStopped = false;

  /**
   * @param {Program[]} programs
   * @param {number} seeds number of trials
   * @param {(done: number, secondsLeft: number) => void} progressed
   * @returns {Promise<Mark[]>} the grades; after a call to stop, only the grades so far
   */
  async grade(programs, seeds, progressed) {
    this.#isStopped = false;
    const marks = [];
    const begun = performance.now();
    let graded = 0;
    for (const program of programs) {
      const key = JSON.stringify([seeds, program]);
      const isNew = !this.#known.has(key);
      const mark = this.#known.get(key) ?? (await this.#mark(program, seeds));
      if (this.#isStopped) {
        break;
      }
      graded += Number(isNew);
      this.#known.set(key, mark);
      marks.push(mark);
      const seconds = (performance.now() - begun) / 1000;
      progressed(marks.length, ((programs.length - marks.length) * seconds) / Math.max(1, graded));
    }
    return marks;
  }

  /** Stops grading: terminates the running program and starts no other. */
  stop() {
    this.#isStopped = true;
    this.#worker?.close();
  }

  /** @param {Program} program @param {number} seeds @returns {Promise<Mark>} */
  async #mark({ student, exercise, file, files }, seeds) {
    try {
      return { student, exercise, judged: await this.#judge(exercise, file, files, seeds) };
    } catch (failure) {
      return { student, exercise, reason: /** @type {Error} */ (failure).message };
    }
  }

  /** @param {string} exercise @param {string} file @param {Record<string, string>} files @param {number} seeds */
  async #judge(exercise, file, files, seeds) {
    const { remarks, classes } = await this.#compiler.compile(
      withReferences(new Map(Object.entries(files)), file),
      file,
    );
    const wrong = remarks.find(({ serious }) => serious);
    if (wrong) {
      throw new Error(`It does not compile: ${wrong.line > 0 ? `${file}:${wrong.line}: ` : ''}${wrong.text}`);
    }
    const worker = new ClassWorker();
    this.#worker = worker;
    try {
      return await worker.judge(exercise, seeds, classes, motionsOf(files));
    } finally {
      worker.close();
    }
  }
}
