/** A page that observes a running process: stores its reports and redraws at most once per animation frame. */
import { Connection } from './connection.js';

/** @template {{phase: import('../state/reports.js').Phase, refusal: string}} T */
export class ReportPage {
  #draw;
  #asked = false;

  /**
   * @param {string} feed address of the live messages
   * @param {T} known initial state
   * @param {{received: (known: T, news: any) => T, lost: (known: T) => T}} changes
   * @param {() => void} draw
   */
  constructor(feed, known, { received, lost }, draw) {
    this.options = new URLSearchParams(location.search);
    this.known = known;
    this.#draw = draw;
    this.line = new Connection(`ws://${location.host}/${feed}`, {
      opened() {},
      lost: () => this.#become(lost(this.known)),
      refused: (reason) => this.#become({ ...this.known, phase: 'refused', refusal: reason }),
      messageArrived: (news) => this.#become(received(this.known, news)),
      frameArrived() {},
    });
  }

  open() {
    this.line.open();
    this.#draw();
    // The browser may keep a page in its cache with an open connection, but the program waits until all viewers have left.
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
