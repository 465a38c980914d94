/** Output panel of a program: errors with their line numbers, values, log, printed text and verdicts. */
import { button, element, setText } from '../panels/elements.js';
import { valueText } from '../state/program/values.js';

const MAX_LINES = 200;
const NOTHING = 'Output of log.info("…"), nao.plot("name", value) and System.out.println("…") appears here.';

export class SaidPanel {
  /** @param {HTMLElement} place @param {(line: number) => void} goTo */
  constructor(place, goTo) {
    this.goTo = goTo;
    this.place = place;
    /** Container for the result of the grading. */
    this.verdict = element('div', { id: 'program-verdict' });
    this.compiler = element('ul', { id: 'program-remarks', 'aria-label': 'Errors found by the compiler' });
    this.mistakes = element('ul', { id: 'program-mistakes', 'aria-label': 'Errors of the running program' });
    /** Container for the sliders for the program's tunable numbers. */
    this.sliders = element('div', {
      id: 'program-sliders',
      role: 'group',
      'aria-label': 'Adjustable numbers in the program',
    });
    this.values = element('p', { id: 'program-values', role: 'group', 'aria-label': 'Values that the program plots' });
    this.log = element('ol', { id: 'program-log', 'aria-label': 'Log of the robot' });
    this.printed = element('pre', { id: 'program-printed' });
    this.silence = element('p', { class: 'faint' }, NOTHING);
    const head = element('div', { class: 'program-head' }, this.sliders, this.values);
    place.append(this.verdict, this.compiler, this.mistakes, head, this.silence, this.log, this.printed);
  }

  /** Clears the output of the running program. */
  clear() {
    this.log.replaceChildren();
    this.values.replaceChildren();
    this.mistakes.replaceChildren();
    setText(this.printed, '');
    this.silence.hidden = false;
  }

  /** @param {readonly import('../state/program/remarks.js').Remark[]} remarks */
  showRemarks(remarks) {
    this.compiler.replaceChildren(...remarks.map(({ line, text, hint }) => this.#entry(line, text, hint)));
  }

  /** @param {readonly import('../state/program/remarks.js').Mistake[]} mistakes */
  showMistakes(mistakes) {
    this.silence.hidden ||= mistakes.length > 0;
    this.mistakes.replaceChildren(...mistakes.map(({ line, text }) => this.#entry(line, text, '')));
  }

  /** @param {ReadonlyMap<string, number>} values */
  showValues(values) {
    this.silence.hidden = true;
    this.values.replaceChildren(
      ...[...values].map(([name, value]) => element('span', {}, `${name} `, element('b', {}, valueText(value)))),
    );
  }

  /** @param {import('../state/robot/telemetry.js').LogLine} line */
  addLine({ seconds, level, text }) {
    const isAtEnd = this.place.scrollHeight - this.place.scrollTop - this.place.clientHeight < 40;
    this.silence.hidden = true;
    this.log.append(element('li', { class: level.toLowerCase() }, `${seconds.toFixed(2)} s  ${text}`));
    while (this.log.children.length > MAX_LINES) {
      this.log.children[0].remove();
    }
    if (isAtEnd) {
      this.place.scrollTop = this.place.scrollHeight;
    }
  }

  /** @param {string} text printed by the program */
  showOutput(text) {
    setText(this.printed, text);
    this.silence.hidden ||= text !== '';
  }

  /** @param {number} line @param {string} text @param {string} hint */
  #entry(line, text, hint) {
    const words = `${text}${hint ? ` — ${hint}` : ''}`;
    const place =
      line > 0 ? [button(`Line ${line}`, 'Go to this line', () => this.goTo(line), { class: 'quiet' })] : [];
    return element('li', {}, ...place, ` ${words}`);
  }
}
