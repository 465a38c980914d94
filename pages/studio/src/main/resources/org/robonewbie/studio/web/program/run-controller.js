/** Runs the program and shows its log, its plots, and its errors below the lines in which they occurred. */
import { button, byId, choice, element, setText } from '../panels/elements.js';
import { keep, recall } from '../panels/memory.js';
import { lineOf, withMistake } from '../state/program/remarks.js';
import { crashOf, isUnderWay, NO_RUN, ownRobot, runText, withoutReports } from '../state/program/run.js';
import { valuesAtLines } from '../state/program/values.js';
import { readTelemetry, robotKey } from '../state/robot/telemetry.js';
import { copyExample } from './new-program.js';
import { SliderController } from './slider-controller.js';

/** @typedef {import('../state/program/run.js').ProgramRun} ProgramRun */

const KEY = 'robonewbie-program-world';
const LOOK_MILLISECONDS = 400;
const VALUE_MILLISECONDS = 200;

export class RunController {
  #isPolling = false;
  #valuesAt = 0;
  #robot = '';
  /** @type {string[]} */
  #before = [];
  /** @type {Map<string, number>} */
  #values = new Map();
  /** @type {readonly import('../state/program/remarks.js').Mistake[]} */
  #mistakes = [];
  /** Messages of the robot's warnings and errors. @type {Set<string>} */
  #reports = new Set();
  #remarks = '';
  #hasMistakes = false;

  /** @param {any} room */
  constructor(room) {
    this.room = room;
    this.service = room.service;
    /** @type {ProgramRun} */
    this.now = NO_RUN;
    const act = (/** @type {() => Promise<void>} */ action) => () => room.attempt(action);
    this.start = button(
      '▶ Run',
      'Saves and runs the program (Ctrl+Enter)',
      act(() => this.run()),
      {
        id: 'program-run',
        class: 'primary',
      },
    );
    this.stopButton = button(
      '■ Stop',
      'Stops the program',
      act(() => this.stop()),
      { id: 'program-stop' },
    );
    this.restartButton = button(
      '⟲ Restart',
      'Restarts the world and the program',
      act(() => this.#start('fresh')),
      {
        id: 'program-restart',
      },
    );
    this.stepButton = button(
      'Step',
      'Runs one cycle of 20 ms with one call of think(); then the world pauses until Play (Space) or Run',
      () => room.surroundings.send({ do: 'step', cycles: 1 }),
      { id: 'program-step' },
    );
    this.world = worldChoice();
    this.state = element('p', { id: 'program-state', role: 'status' });
    this.sliders = this.#newSliders();
    room.bar.append(this.start, this.stopButton, this.restartButton, this.stepButton);
    room.foot.append(this.state, this.world);
  }

  /** Saves the program and runs it. */
  async run() {
    await copyExample(this.room.files);
    if (!(await this.room.firstMinute.run()) && (await this.room.files.save())) {
      await this.#start(isUnderWay(this.now) ? this.#chosenWorld : 'fresh');
    }
  }

  /** Called after a save; hot-swaps the program if it is running, and otherwise clears the messages of its last run. */
  async saved() {
    if (this.now.program !== this.room.files.file?.path) {
      return;
    }
    if (isUnderWay(this.now)) {
      await this.#start(this.#chosenWorld);
    } else {
      this.#clearMessages();
      this.#show(NO_RUN);
    }
  }

  async stop() {
    this.#show(await this.service.stop());
  }

  /** @returns {'keep' | 'fresh'} */
  get #chosenWorld() {
    return this.world.value === 'fresh' ? 'fresh' : 'keep';
  }

  /** @param {'keep' | 'fresh'} world */
  async #start(world) {
    const { file } = this.room.files;
    if (!file || file.kind === 'example') {
      return;
    }
    await this.room.exercises.leave();
    if (!isUnderWay(this.now)) {
      this.#before = this.#keys();
    }
    if (this.now.program !== file.path) {
      this.sliders.forget();
    }
    this.#show({ ...NO_RUN, state: 'STARTING', program: file.path });
    this.room.surroundings.goLive();
    const run = await this.service.run(file.path, world);
    if (run.state === 'REFUSED') {
      await this.room.check();
      await this.look();
      this.#showState(runText(run), 'trouble');
    } else {
      this.#clearMessages();
      this.forgetRobot(); // the next subscription delivers what the new program has already reported
      this.#show(run);
      this.#watch();
    }
  }

  /** Clears the messages of the previous version of the program. */
  #clearMessages() {
    this.forgetMistakes();
    this.room.surroundings.clearErrors();
  }

  /** Polls the run once. */
  async look() {
    this.#show(await this.service.state());
    if (isUnderWay(this.now)) {
      this.#watch();
    }
  }

  /** Polls as long as the program is running. */
  async #watch() {
    if (this.#isPolling) {
      return;
    }
    this.#isPolling = true;
    while (isUnderWay(this.now)) {
      this.#listen();
      await new Promise((done) => setTimeout(done, LOOK_MILLISECONDS));
      try {
        this.#show(await this.service.state());
      } catch {
        // The studio is down or restarting, which the connection banner reports.
      }
    }
    this.#isPolling = false;
  }

  /** @param {ProgramRun} run */
  #show(run) {
    this.now = run;
    this.#showOutput();
    this.#showMistakes();
    this.draw();
  }

  /** Shows the errors below the lines in which they occurred, if the program is open. */
  #showMistakes() {
    if (this.now.program === this.room.files.file?.path) {
      const crash = crashOf(this.now);
      this.room.editor.setMistakes(crash ? withMistake(this.#mistakes, crash) : this.#mistakes);
    }
  }

  #showOutput() {
    this.room.said.showOutput(withoutReports(this.now.output, this.#reports));
  }

  draw() {
    const { file, list } = this.room.files;
    const isRunning = isUnderWay(this.now);
    this.start.hidden = isRunning && this.now.program === file?.path;
    const hasClock = this.room.surroundings.hasClock();
    this.world.hidden = !hasClock;
    this.stopButton.hidden = !isRunning;
    this.restartButton.hidden = this.stepButton.hidden = !isRunning || !hasClock;
    const { status } = this.room.exercises;
    const isTrouble = status === '' && this.now.state === 'ENDED' && this.now.exitCode !== 0;
    this.#showState(
      status || runText(this.now, this.now.id === 0 ? list.first?.example : ''),
      isTrouble ? 'trouble' : '',
    );
  }

  /** @param {string} text @param {string} tone */
  #showState(text, tone) {
    const mistakes = this.#hasMistakes ? `${this.#remarks}. ` : '';
    setText(this.state, `${mistakes}${text}`);
    this.state.dataset.tone = this.#hasMistakes ? 'trouble' : tone;
  }

  /** @param {string} text @param {readonly import('../state/program/remarks.js').Remark[]} remarks the compiler's remarks */
  showRemarks(text, remarks) {
    this.#remarks = text;
    this.#hasMistakes = remarks.some(({ serious }) => serious);
    this.draw();
  }

  /** Called after an edit, so that the values are shown at the correct lines without delay. */
  edited() {
    this.#valuesAt = 0;
  }

  forgetMistakes() {
    this.#mistakes = [];
    this.#reports.clear();
    this.#values.clear();
    this.room.editor.setMistakes([]);
    this.room.editor.setValues([]);
    this.room.said.clear();
    this.sliders.begin();
  }

  #newSliders() {
    const { said, editor, files } = this.room;
    return new SliderController(said.sliders, {
      tune: (name, value) => this.#tune(name, value),
      text: () => (this.now.program === files.file?.path ? editor.text : ''),
      write: (text) => editor.replace(text),
    });
  }

  /** Changes a tunable number in the running program. @param {string} name @param {number} value */
  #tune(name, value) {
    const [team, number] = this.#robot.split('\t');
    this.room.surroundings.send({ do: 'tune', team, number: Number(number), name, value });
  }

  #keys() {
    return this.room.surroundings
      .robots()
      .map((/** @type {{team: string, number: number}} */ { team, number }) => robotKey(team, number));
  }

  /** Subscribes to the telemetry of the program's robot; a page receives that of only one robot at a time. */
  #listen() {
    const key = ownRobot(this.#robot, this.#before, this.#keys(), this.now.entersFirst);
    if (key !== '' && key !== this.#robot && !byId('program-room').hidden) {
      const [team, number] = key.split('\t');
      this.#robot = key;
      this.forgetMistakes();
      this.room.surroundings.send({ do: 'watch', team, number: Number(number) });
    }
  }

  /** Called when another room has subscribed to a different robot. */
  forgetRobot() {
    this.#robot = '';
  }

  /** @param {{robot: string, lines: string[]}} news telemetry of a robot */
  receive({ robot, lines }) {
    if (robot !== this.#robot) {
      return;
    }
    for (const each of lines.map(readTelemetry)) {
      if (each.kind === 'log') {
        this.#addLogLine(each.log);
      } else if (each.kind === 'plot') {
        this.#values.set(each.name, each.value);
      } else if (each.kind === 'number') {
        this.sliders.receive(each.number);
      }
    }
    this.#showValues();
  }

  /**
   * Shows a log line: an error below the line in which it occurred, anything else in the log. @param
   * {import('../state/robot/telemetry.js').LogLine} log
   */
  #addLogLine(log) {
    const isReport = ['WARNING', 'ERROR'].includes(log.level);
    const line = isReport && this.now.program === this.room.files.file?.path ? lineOf(log.text, this.now.program) : 0;
    if (line > 0) {
      this.#mistakes = withMistake(this.#mistakes, { line, text: log.text });
      this.#showMistakes();
      this.room.said.showMistakes(this.#mistakes);
    } else {
      this.room.said.addLine(log);
    }
    if (isReport) {
      this.#reports.add(log.text);
      this.#showOutput();
    }
  }

  #showValues() {
    const now = performance.now();
    if (this.#values.size === 0 || now - this.#valuesAt < VALUE_MILLISECONDS) {
      return;
    }
    this.#valuesAt = now;
    this.room.said.showValues(this.#values);
    this.room.editor.setValues(valuesAtLines(this.room.editor.text, this.#values));
  }
}

function worldChoice() {
  const world = choice(
    { id: 'program-world', 'aria-label': 'What happens to the world when a running program is saved' },
    [
      ['keep', 'Saving keeps the world'],
      ['fresh', 'Saving restarts the world'],
    ],
    (value) => keep(KEY, value),
  );
  world.value = recall(KEY, 'keep');
  return world;
}
