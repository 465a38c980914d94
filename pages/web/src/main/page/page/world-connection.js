/** Connection to a world in a worker of this page; the counterpart of the WebSocket connection in `live/connection.js`. */

const SEED = 1;

export class WorldConnection {
  /**
   * @param {import('./world-process.js').World} worker
   * @param {import('../live/connection.js').Listener} listener
   * @param {import('./agent-choice.js').AgentChoice} choice
   * @param {object} servers
   * @param {import('./program-server.js').ProgramServer} servers.programs
   * @param {import('./course-server.js').CourseServer} servers.course
   * @param {import('./world-questions.js').WorldQuestions} servers.questions
   * @param {import('./scene-server.js').SceneServer} servers.scenes
   * @param {import('./page-recordings.js').PageRecordings} servers.recordings
   */
  constructor(worker, listener, choice, { programs, course, questions, recordings, scenes }) {
    this.programs = programs;
    this.course = course;
    this.questions = questions;
    this.recordings = recordings;
    this.scenes = scenes;
    this.listener = listener;
    this.choice = choice;
    this.worker = worker;
    this.worker.listen(
      ({ data }) => this.#receive(data),
      (event) => this.#fail(event.message),
    );
    choice.onChoice(
      () => this.#begin(this.choice.all),
      (agent) => this.worker.postMessage({ join: agent }),
    );
  }

  open() {
    this.#begin(this.choice.all);
  }

  /** @param {object} command command such as `{do: 'pause'}` */
  send(command) {
    this.worker.postMessage({ ask: command });
  }

  /** A worker of the same page needs no timeout. */
  checkSilence() {}

  /** @param {string[]} agents the agents that play; empty for an empty pitch */
  #begin(agents) {
    this.programs.forget();
    this.worker.postMessage({ begin: { agents, seed: SEED } });
  }

  /** @param {any} data a text message, a state frame, or a status message from the worker */
  #receive(data) {
    if (typeof data === 'string') {
      this.listener.messageArrived(JSON.parse(data));
    } else if (data instanceof ArrayBuffer) {
      this.listener.frameArrived(data);
    } else if ('recorded' in data) {
      this.recordings.receive(data.recorded, data.first);
    } else if ('recording' in data) {
      this.recordings.keep(data.recording);
    } else if ('noted' in data) {
      this.recordings.note(data.noted);
    } else if ('begun' in data) {
      this.recordings.agent = data.begun || this.programs.lastTried;
      this.choice.offer(data.agents, data.begun);
      this.listener.opened();
    } else if ('run' in data) {
      this.programs.receive(data.run);
    } else if ('progress' in data) {
      this.course.keep(data.progress);
    } else if ('starter' in data) {
      this.course.create(data.starter);
    } else if ('freePitch' in data) {
      this.#begin([]);
    } else if ('result' in data) {
      this.questions.answered(data);
    } else if ('scene' in data) {
      this.scenes.keep(data.scene);
    } else if ('refusal' in data) {
      this.programs.refused(data.refusal);
    } else {
      this.#fail(data.failure);
    }
  }

  /** @param {string} reason */
  #fail(reason) {
    this.listener.refused(`The simulator on this page has failed: ${reason}. Reload the page.`);
  }
}
