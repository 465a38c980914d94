/** Exercise panel: select an exercise, run a program on it, and follow its grading live. */
import { answer } from '../live/server.js';
import {
  byLevel,
  hints,
  lessonLine,
  lessonTitle,
  progressText,
  startingText,
  trialText,
  likelyProgram,
} from '../state/course.js';
import { ClassLink } from './class-link.js';
import { CourseHelp } from './course-help.js';
import { CourseStandings } from './course-standings.js';
import { button, byId, check, choice, element, setEntries, setText } from './elements.js';
import { offerRoom } from './rooms.js';

/**
 * @typedef {import('../state/course.js').Lesson} Lesson
 * @typedef {import('../state/course.js').Attempt} Attempt
 */

const PLACE = '#field/exercises';
const LOOK_MILLISECONDS = 400;
const LANGUAGES = /** @type {const} */ ([
  ['en', 'English'],
  ['de', 'Deutsch'],
]);
const TRIALS = ['1', '3', '10'];
const DEFAULT_TRIALS = '3';

export class CoursePanel {
  #note;
  #goLive;
  #announce;
  /** @type {Lesson[]} */
  #lessons = [];
  /** @type {Lesson | undefined} */
  #chosen;
  #shown = '';
  #isPolling = false;
  #help = new CourseHelp();
  #language = choice(
    {
      id: 'course-language',
      'aria-label': 'Language of the exercises',
      title: 'Language of worksheets, hints and results',
    },
    LANGUAGES,
    (code) => this.#attemptTo(() => this.#speak(code)),
  );
  #standings = new CourseStandings();
  #classLink = new ClassLink();
  /** @type {ReturnType<typeof parts>} */
  #parts;

  /**
   * @param {(text: string) => void} note
   * @param {() => void} goLive returns to the present
   * @param {(starting: string) => void} announce shows what is about to replace the scene
   * @param {(on: boolean) => void} showGhost shows or hides the ghost of the previous trial
   */
  constructor(note, goLive, announce, showGhost) {
    this.#note = note;
    this.#goLive = goLive;
    this.#announce = announce;
    const ghost = check(
      'course-ghost',
      'Ghost of my last trial',
      'Shows your last trial beside the current one',
      showGhost,
    );
    ghost.box.checked = true;
    this.#parts = parts(this.#help.element, ghost.label);
    const { back, here, write, start, stop, list, detail } = this.#parts;
    const head = element('div', { class: 'course-head' }, element('h2', {}, 'Exercises'), this.#language);
    byId('course').append(head, this.#standings.element, list, detail, this.#classLink.element);
    back.addEventListener('click', () => this.#choose(undefined));
    here.addEventListener('click', () => {
      location.hash = `#program/${this.#chosen?.name ?? ''}`;
    });
    write.addEventListener('click', () => this.#attemptTo(() => this.#write()));
    start.addEventListener('click', () => this.#attemptTo(() => this.#start()));
    stop.addEventListener('click', () => this.#attemptTo(() => this.#stop()));
    window.addEventListener('hashchange', () => this.#show());
    this.#attemptTo(() => this.#open());
  }

  async #open() {
    await this.#refresh();
    offerRoom(PLACE, this.#lessons.length > 0);
    this.#choose(undefined);
    this.#show();
  }

  /** @param {Lesson} lesson */
  #entry(lesson) {
    const made = button(lessonTitle(lesson), lesson.goal, () => this.#choose(lesson));
    made.dataset.exercise = lesson.name;
    made.dataset.passed = String(lesson.standing.passed);
    made.append(element('small', {}, lessonLine(lesson)));
    return element('li', {}, made);
  }

  #show() {
    const panel = byId('course');
    panel.hidden = location.hash !== PLACE || this.#lessons.length === 0;
    byId('field-room').dataset.exercises = panel.hidden ? 'off' : 'on';
    if (!panel.hidden && !this.#isPolling) {
      this.#isPolling = true;
      this.#look();
    }
  }

  /** @param {Lesson | undefined} lesson */
  #choose(lesson) {
    const { list, detail } = this.#parts;
    this.#chosen = lesson;
    list.hidden = lesson !== undefined;
    detail.hidden = lesson === undefined;
    this.#standings.element.hidden = lesson !== undefined;
    this.#classLink.element.hidden = lesson !== undefined;
    if (lesson) {
      this.#describe(lesson);
      this.#attemptTo(() => this.#refresh());
    }
  }

  /** @param {Lesson} lesson */
  #describe(lesson) {
    const { title, line, goal, worksheet } = this.#parts;
    setText(title, lessonTitle(lesson));
    setText(line, lessonLine(lesson));
    setText(goal, lesson.goal);
    worksheet.href = lesson.worksheet;
  }

  /** @param {string} code language code */
  async #speak(code) {
    await answer('POST course/language', { code });
    await this.#refresh();
  }

  async #refresh() {
    const { language, lessons, programs, acceptsAgents, standings } = await answer('GET course');
    this.#language.value = language;
    this.#lessons = byLevel(lessons);
    this.#classLink.show(this.#lessons);
    this.#parts.list.replaceChildren(...this.#lessons.map((lesson) => this.#entry(lesson)));
    if (standings) {
      this.#standings.show(standings);
    }
    this.#chosen = this.#lessons.find(({ name }) => name === this.#chosen?.name);
    const lesson = this.#chosen;
    if (lesson) {
      this.#describe(lesson);
      await this.#help.show(lesson.name);
      const { program, write } = this.#parts;
      const before = program.value;
      const entries = programs.map((/** @type {string} */ name) => /** @type {const} */ ([name, name]));
      setEntries(program, acceptsAgents ? [...entries, ['', 'From my IDE']] : entries);
      this.#offerStart(acceptsAgents);
      program.value = likelyProgram(lesson, programs) || (programs.includes(before) ? before : '');
      setText(write, `Create ${lesson.file}`);
      write.hidden = programs.includes(lesson.file);
    }
  }

  /** @param {boolean} isPossible whether programs can be started here, not only in the Program room */
  #offerStart(isPossible) {
    const { program, trials, start } = this.#parts;
    [program, trials, start].forEach((each) => {
      each.hidden = !isPossible;
    });
  }

  async #write() {
    if (this.#chosen) {
      const file = await answer('PUT course/NAME', { NAME: this.#chosen.name });
      await this.#refresh();
      this.#note(`The starter code ${file} was created. Edit it, then press Start.`);
    }
  }

  async #start() {
    const { program, trials } = this.#parts;
    if (this.#chosen) {
      const how = { program: program.value, trials: program.value ? trials.value : '1' };
      this.#draw(await answer('POST course/NAME', { NAME: this.#chosen.name, ...how }));
      this.#goLive();
    }
  }

  async #stop() {
    this.#draw(await answer('DELETE course/attempt'));
    this.#goLive();
  }

  /** Polls the progress of the attempt while the panel is visible. */
  async #look() {
    while (!byId('course').hidden) {
      try {
        this.#draw(await answer('GET course/attempt'));
      } catch {
        // the studio is down or restarting, which the connection banner reports
      }
      await new Promise((done) => setTimeout(done, LOOK_MILLISECONDS));
    }
    this.#isPolling = false;
  }

  /** @param {Attempt} attempt */
  #draw(attempt) {
    const { progress, judged, advice, output, printed, stop } = this.#parts;
    const text = JSON.stringify(attempt);
    if (text === this.#shown) {
      return;
    }
    this.#shown = text;
    this.#announce(startingText(attempt));
    if (attempt.state === 'OVER') {
      this.#attemptTo(() => this.#refresh());
    }
    stop.hidden = attempt.state === 'NONE';
    setText(stop, attempt.state === 'OVER' ? 'Back to the free pitch' : 'Stop');
    setText(progress, progressText(attempt));
    progress.dataset.state = attempt.state === 'OVER' && attempt.passed ? 'passed' : attempt.state.toLowerCase();
    judged.replaceChildren(
      ...attempt.judged.map((trial) => element('li', { 'data-passed': String(trial.passed) }, trialText(trial))),
    );
    advice.replaceChildren(...hints(attempt).map((hint) => element('p', {}, `Hint: ${hint}`)));
    setText(printed, attempt.output);
    output.hidden = attempt.output === '';
  }

  /** @param {() => Promise<void>} action */
  #attemptTo(action) {
    action().catch((error) => this.#note(error.message));
  }
}

function parts(/** @type {HTMLElement} */ help, /** @type {HTMLElement} */ ghost) {
  const made = { ...words(), ...controls(), ...verdicts() };
  const { program, trials, start, stop, write, here } = made;
  made.output.append(made.printed);
  const detail = element(
    'div',
    { class: 'lesson' },
    ...[made.back, made.title, made.line, made.goal, element('p', {}, made.worksheet)],
    element('div', { class: 'scene-line' }, here),
    element('div', { class: 'scene-line' }, program, trials),
    element('div', { class: 'scene-line' }, start, stop, write),
    ghost,
    ...[made.progress, made.judged, made.advice, made.output, help],
  );
  return { ...made, detail };
}

/** Elements that describe an exercise. */
function words() {
  return {
    list: element('ol', { class: 'lessons' }),
    back: element('button', { type: 'button', class: 'quiet', title: 'Shows all exercises' }, '← All exercises'),
    title: element('h3', {}),
    line: element('p', { class: 'faint' }),
    goal: element('p', {}),
    worksheet: element('a', { target: 'robonewbie-docs' }, 'Worksheet'),
  };
}

/** Controls for an attempt. */
function controls() {
  const control = (/** @type {string} */ id, /** @type {string} */ title, text = '', kind = '') =>
    element('button', { type: 'button', id, title, class: kind }, text);
  const counts = TRIALS.map((count) => /** @type {const} */ ([count, count === '1' ? '1 trial' : `${count} trials`]));
  const trials = choice({ id: 'course-trials', 'aria-label': 'Trials' }, counts, () => {});
  trials.value = DEFAULT_TRIALS;
  return {
    program: element('select', { id: 'course-program', 'aria-label': 'Program to run' }),
    trials,
    here: control(
      'course-here',
      'Opens your program, or the starter code, in the Program room',
      'Edit beside the robot',
      'primary',
    ),
    write: control('course-write', 'Creates the starter code in the working folder'),
    start: control('course-start', 'Runs the program on this pitch and grades it', 'Start'),
    stop: control('course-stop', 'Ends the attempt and shows the free pitch', 'Stop'),
  };
}

/** Results of an attempt. */
function verdicts() {
  return {
    progress: element('p', { id: 'course-progress', role: 'status' }),
    judged: element('ul', { id: 'course-judged' }),
    advice: element('div', { id: 'course-hints' }),
    printed: element('pre', {}),
    output: element('details', { id: 'course-output' }, element('summary', {}, 'Program output')),
  };
}
