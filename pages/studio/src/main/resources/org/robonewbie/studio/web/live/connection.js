/** WebSocket connection to the simulator: opens and reopens it, and forwards incoming data. */

const RETRY_MILLISECONDS = 400;
const MAX_MISSED_CHECKS = 10;

/**
 * @typedef {object} Listener
 * @property {() => void} opened
 * @property {() => void} lost
 * @property {(reason: string) => void} refused called if the simulator is running but refuses this page
 * @property {(news: any) => void} messageArrived called when a JSON message has arrived
 * @property {(bytes: ArrayBuffer) => void} frameArrived called when a state frame has arrived
 */

/**
 * @typedef {object} Line connection to a world, in another process or in a worker
 * @property {() => void} open
 * @property {(command: object) => void} send
 * @property {() => void} checkSilence
 */

/**
 * Connects to the simulator that served this page.
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
   * @param {string} address address of the live feed
   * @param {Listener} listener
   */
  constructor(address, listener) {
    this.address = address;
    this.listener = listener;
    /** Number of checks since data last arrived. */
    this.missedChecks = 0;
    /** @type {WebSocket | undefined} */
    this.socket = undefined;
    document.addEventListener('visibilitychange', () => {
      this.missedChecks = 0;
    });
  }

  open() {
    const socket = new WebSocket(this.address);
    let wasOpen = false;
    socket.binaryType = 'arraybuffer';
    socket.onopen = () => {
      if (this.#wasRefused) {
        location.reload(); // another page has authorised this browser; reload to repeat the refused requests
      }
      wasOpen = true;
      this.missedChecks = 0;
      this.listener.opened();
    };
    socket.onmessage = (event) => this.#receive(event.data);
    socket.onclose = () => {
      if (this.socket === socket) {
        this.#lose();
        if (!wasOpen) {
          this.#fetchRefusal();
        }
      }
    };
    this.socket = socket;
  }

  /**
   * Sends a command to the simulator. Ignored if there is no connection.
   *
   * @param {object} command command such as `{do: 'pause'}`
   */
  send(command) {
    if (this.socket?.readyState === WebSocket.OPEN) {
      this.socket.send(JSON.stringify(command));
    }
  }

  /**
   * Closes a stalled connection, for example after the computer has been suspended, unless the page is hidden. Call twice per second.
   * Checks are counted rather than seconds, so that a page that was itself blocked does not time out.
   */
  checkSilence() {
    this.missedChecks += 1;
    if (this.missedChecks > MAX_MISSED_CHECKS && !document.hidden && this.socket?.readyState === WebSocket.OPEN) {
      const stalled = this.socket;
      this.#lose();
      stalled.close();
    }
  }

  /** @param {string | ArrayBuffer} data */
  #receive(data) {
    this.missedChecks = 0;
    if (typeof data === 'string') {
      this.listener.messageArrived(JSON.parse(data));
    } else {
      this.listener.frameArrived(data);
    }
  }

  /** Makes a plain HTTP request to find out why the WebSocket was refused, because browsers do not report the reason. */
  async #fetchRefusal() {
    try {
      const answer = await fetch(this.address.replace(/^ws/, 'http'), { method: 'POST' });
      if (answer.status === 403) {
        this.#wasRefused = true;
        this.listener.refused(await answer.text());
      }
    } catch {
      // The server is down; another attempt follows soon.
    }
  }

  #lose() {
    this.socket = undefined;
    this.listener.lost();
    setTimeout(() => this.open(), RETRY_MILLISECONDS);
  }
}
