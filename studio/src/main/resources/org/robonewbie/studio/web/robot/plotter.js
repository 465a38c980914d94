/** Draws curves with uPlot, which is loaded when curves are wanted first. */

const ADDRESS = 'vendor/uplot/uplot.min.js';
const HEIGHT = 96;
const COLOURS = 6;

/** @type {Promise<void> | undefined} */
let loading;

/** @returns {any} the library, undefined as long as it is not there */
export const uPlot = () => /** @type {any} */ (window).uPlot;

/** @returns {Promise<void>} */
export function loadPlotter() {
  loading ??= new Promise((done, failed) => {
    const script = document.createElement('script');
    script.src = ADDRESS;
    script.addEventListener('load', () => done());
    script.addEventListener('error', () => failed(new Error('The curves cannot be drawn: a part of the page is missing. Load the page again.')));
    document.head.append(script);
  });
  return loading;
}

/**
 * @param {HTMLElement} place
 * @param {readonly string[]} names
 * @param {{width: number, seek: (seconds: number) => void, zoomed: (range: {from: number, to: number}) => void}} options
 * @returns {any} a plot; undefined as long as the library is not there or there is no room
 */
export function newPlot(place, names, { width, seek, zoomed }) {
  place.replaceChildren();
  if (!uPlot() || width < 50 || names.length === 0) {
    return undefined;
  }
  const style = getComputedStyle(place);
  const colour = (/** @type {string} */ name) => style.getPropertyValue(name).trim();
  let moment = 0;
  const plot = new (uPlot())(
    {
      width,
      height: HEIGHT,
      legend: { show: false },
      cursor: { sync: { key: 'robot', setSeries: false }, drag: { x: true, y: false, setScale: false }, points: { size: 6 } },
      scales: { x: { time: false }, y: { range: roomy } },
      axes: axes(colour),
      series: [{}, ...names.map((name, i) => ({ label: name, stroke: () => colour(`--curve-${i % COLOURS}`), width: 1.5, spanGaps: true, points: { show: false }, dash: i < COLOURS ? undefined : [6, 3] }))],
      hooks: {
        draw: [(/** @type {any} */ drawn) => drawMoment(drawn, moment, colour('--ink'))],
        setSelect: [
          (/** @type {any} */ chosen) => {
            if (chosen.select.width > 4) {
              zoomed({ from: chosen.posToVal(chosen.select.left, 'x'), to: chosen.posToVal(chosen.select.left + chosen.select.width, 'x') });
            }
            chosen.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
          },
        ],
      },
    },
    [[], ...names.map(() => [])],
    place,
  );
  let pressedAt = 0;
  plot.over.addEventListener('pointerdown', (/** @type {PointerEvent} */ event) => {
    pressedAt = event.clientX;
  });
  plot.over.addEventListener('click', (/** @type {MouseEvent} */ event) => {
    if (Math.abs(event.clientX - pressedAt) < 4) {
      seek(plot.posToVal(event.offsetX, 'x'));
    }
  });
  plot.showMoment = (/** @type {number} */ seconds) => {
    moment = seconds;
  };
  return plot;
}

/** Axes in the colours of the theme. @param {(name: string) => string} colour */
export function axes(colour) {
  const axis = { stroke: () => colour('--faint'), grid: { stroke: () => colour('--edge'), width: 1 }, ticks: { show: false }, font: '12px system-ui, sans-serif' };
  return [{ ...axis, size: 22, gap: 2 }, { ...axis, size: 46, gap: 2 }];
}

/** A flat curve lies in the middle. @param {any} _ @param {number | null} least @param {number | null} most */
export function roomy(_, least, most) {
  const [low, high] = [least ?? 0, most ?? 1];
  const room = Math.max((high - low) * 0.08, Math.abs(high) * 0.005, 0.01);
  return [low - room, high + room];
}

/** @param {any} plot @param {number} seconds @param {string} colour */
function drawMoment(plot, seconds, colour) {
  const x = Math.round(plot.valToPos(seconds, 'x', true));
  const { left, top, width, height } = plot.bbox;
  if (x >= left && x <= left + width) {
    plot.ctx.fillStyle = colour;
    plot.ctx.fillRect(x, top, 1, height);
  }
}
