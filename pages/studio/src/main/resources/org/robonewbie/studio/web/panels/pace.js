/** Throttles drawing to a readable rate. */

/**
 * @param {(now: number) => void} draw
 * @param {number} milliseconds minimum interval between two drawings
 * @returns {{ask: () => void, turn: (now: number) => void}} `ask` requests a drawing, `turn` draws once the interval has passed
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
