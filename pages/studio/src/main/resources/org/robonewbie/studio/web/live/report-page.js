/** A page that watches something run: it keeps what is known and draws it at most once per picture of the browser. */
import { Connection } from './connection.js';

/** @template {{phase: import('../state/reports.js').Phase, refusal: string}} T */
export class ReportPage {
  #draw;
  #asked = false;

  /**
   * @param {string} board the address of the live messages
   * @param {T} known what is known at first
   * @param {{told: (known: T, news: any) => T, lost: (known: T) => T}} changes
   * @param {() => void} draw
   */
  constructor(board, known, { told, lost }, draw) {
    this.options = new URLSearchParams(location.search);
    this.known = known;
    this.#draw = draw;
    this.line = new Connection(`ws://${location.host}/${board}`, {
      opened() {},
      lost: () => this.#become(lost(this.known)),
      refused: (reason) => this.#become({ ...this.known, phase: 'refused', refusal: reason }),
      told: (news) => this.#become(told(this.known, news)),
      frameArrived() {},
    });
  }

  open() {
    this.line.open();
    this.#draw();
    // A browser may keep a page that was left, with its line; but the program waits for those who look.
    window.addEventListener('pagehide', () => this.line.socket?.close());
  }

  /** @param {T} next */
  #become(next) {
    this.known = next;
    if (!this.#asked) {
      this.#asked = true;
      requestAnimationFrame(() => {
        this.#asked = false;
        this.#draw();
      });
    }
  }
}
