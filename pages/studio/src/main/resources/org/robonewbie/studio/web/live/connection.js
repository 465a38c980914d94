/** The line to the simulator: opens it, opens it again when it breaks, and hands on what arrives. */

const RETRY_MILLISECONDS = 400;
const MOST_SILENT_LOOKS = 10;

/**
 * @typedef {object} Listener
 * @property {() => void} opened
 * @property {() => void} lost
 * @property {(reason: string) => void} refused the simulator is there, but does not want this page
 * @property {(news: any) => void} told a JSON message has come
 * @property {(bytes: ArrayBuffer) => void} frameArrived a state frame has come
 */

/**
 * @typedef {object} Line to a world, wherever it runs
 * @property {() => void} open
 * @property {(command: object) => void} send
 * @property {() => void} checkSilence
 */

/**
 * The line to the simulator that has served this page.
 *
 * @param {Listener} listener
 * @returns {Line}
 */
export function overSocket(listener) {
  return new Connection(`ws://${location.host}/live`, listener);
}

export class Connection {
  #wasRefused = false;

  /**
   * @param {string} address of the live feed
   * @param {Listener} listener
   */
  constructor(address, listener) {
    this.address = address;
    this.listener = listener;
    /** How often one has looked since something has come. */
    this.silentLooks = 0;
    /** @type {WebSocket | undefined} */
    this.socket = undefined;
    document.addEventListener('visibilitychange', () => {
      this.silentLooks = 0;
    });
  }

  open() {
    const socket = new WebSocket(this.address);
    let wasOpen = false;
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => {
      if (this.#wasRefused) {
        location.reload(); // another page of this browser was let in; what this one had asked for before was refused
      }
      wasOpen = true;
      this.silentLooks = 0;
      this.listener.opened();
    };
    socket.onmessage = (event) => this.#receive(event.data);
    socket.onclose = () => {
      if (this.socket === socket) {
        this.#lose();
        if (!wasOpen) {
          this.#askWhy();
        }
      }
    };
    this.socket = socket;
  }

  /**
   * Asks the simulator for something; without a connection nothing happens.
   *
   * @param {object} command such as `{do: 'pause'}`
   */
  send(command) {
    if (this.socket?.readyState === WebSocket.OPEN) {
      this.socket.send(JSON.stringify(command));
    }
  }

  /**
   * Gives up a line on which nothing has come for long, as after a computer has slept; a hidden page asks for nothing. To be
   * called twice per second. Looks are counted instead of seconds: a page that has hung itself has missed nothing.
   */
  checkSilence() {
    this.silentLooks += 1;
    if (this.silentLooks > MOST_SILENT_LOOKS && !document.hidden && this.socket?.readyState === WebSocket.OPEN) {
      const deaf = this.socket;
      this.#lose();
      deaf.close();
    }
  }

  /** @param {string | ArrayBuffer} data */
  #receive(data) {
    this.silentLooks = 0;
    if (typeof data === 'string') {
      this.listener.told(JSON.parse(data));
    } else {
      this.listener.frameArrived(data);
    }
  }

  /** A browser does not tell a page why a WebSocket was refused, but it does so for a plain request. */
  async #askWhy() {
    try {
      const answer = await fetch(this.address.replace(/^ws/, 'http'), { method: 'POST' });
      if (answer.status === 403) {
        this.#wasRefused = true;
        this.listener.refused(await answer.text());
      }
    } catch {
      // Nobody is there; the next attempt comes soon.
    }
  }

  #lose() {
    this.socket = undefined;
    this.listener.lost();
    setTimeout(() => this.open(), RETRY_MILLISECONDS);
  }
}
