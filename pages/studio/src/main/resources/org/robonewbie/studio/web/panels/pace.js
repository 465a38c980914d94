/** Draws something not more often than people can read it. */

/**
 * @param {(now: number) => void} draw
 * @param {number} milliseconds least time between two drawings
 * @returns {{ask: () => void, turn: (now: number) => void}} asks for a drawing, and draws what was asked for when its time has come
 */
export function paced(draw, milliseconds) {
  let asked = false;
  let last = -Infinity;
  return {
    ask() {
      asked = true;
    },
    turn(now) {
      if (asked && now - last >= milliseconds) {
        asked = false;
        last = now;
        draw(now);
      }
    },
  };
}
