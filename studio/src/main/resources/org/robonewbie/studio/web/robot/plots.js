/** Curves of the last seconds, one below the other, with one cursor for all of them. */
import { element, setText } from '../panels/elements.js';
import { extentOf, valueAt } from '../state/robot/traces.js';

/** @typedef {import('../state/robot/traces.js').Trace} Trace */

/** @param {HTMLElement} place @returns {(traces: readonly Trace[]) => void} */
export function plots(place) {
  /** @type {number | undefined} part of the width at which the cursor is */
  let cursor;
  /** @type {Array<{canvas: HTMLCanvasElement, name: HTMLElement, value: HTMLElement}>} */
  let rows = [];
  place.addEventListener('pointermove', (event) => {
    const box = rows[0]?.canvas.getBoundingClientRect();
    cursor = box ? Math.max(0, Math.min(1, (event.clientX - box.left) / box.width)) : undefined;
  });
  place.addEventListener('pointerleave', () => {
    cursor = undefined;
  });
  return (traces) => {
    if (rows.length !== traces.length) {
      rows = traces.map(() => ({ canvas: element('canvas', { class: 'plot' }), name: element('span'), value: element('strong') }));
      place.replaceChildren(...rows.map(({ canvas, name, value }) => element('div', { class: 'plot-row' }, element('div', { class: 'plot-head' }, name, value), canvas)));
    }
    const time = extentOf(traces);
    traces.forEach((trace, i) => {
      const { from, to } = time;
      const seconds = cursor === undefined ? to : from + cursor * (to - from);
      const value = valueAt(trace, seconds);
      setText(rows[i].name, trace.name);
      setText(rows[i].value, value === undefined ? '' : `${value.toFixed(2)} ${trace.unit} at ${seconds.toFixed(2)} s`);
      draw(rows[i].canvas, trace, from, to, cursor);
    });
  };
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {Trace} trace
 * @param {number} from seconds
 * @param {number} to seconds
 * @param {number | undefined} cursor
 */
function draw(canvas, trace, from, to, cursor) {
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  Object.assign(canvas, { width, height });
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const style = getComputedStyle(canvas);
  const { least, most } = extentOf([trace]);
  pen.strokeStyle = style.getPropertyValue('--accent');
  pen.lineWidth = 1.5;
  pen.beginPath();
  for (const [time, value] of trace.points) {
    pen.lineTo(((time - from) / (to - from)) * width, height - ((value - least) / (most - least)) * height);
  }
  pen.stroke();
  pen.fillStyle = style.getPropertyValue('--faint');
  pen.font = '12px system-ui, sans-serif';
  pen.fillText(most.toFixed(1), 4, 12);
  pen.fillText(least.toFixed(1), 4, height - 4);
  if (cursor !== undefined) {
    pen.fillRect(cursor * width, 0, 1, height);
  }
}
