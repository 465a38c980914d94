/** Draws plots with uPlot, which is loaded on first use. */

const ADDRESS = 'vendor/uplot/uplot.min.js';
const HEIGHT = 150;
const COLOURS = 6;
const MIN_DRAG_PIXELS = 4;
const LOOK = {
  height: HEIGHT,
  legend: { show: false },
  cursor: {
    sync: { key: 'robot', setSeries: false },
    drag: { x: true, y: false, setScale: false },
    points: { size: 6 },
  },
  scales: { x: { time: false }, y: { range: roomy } },
};

/** @type {Promise<void> | undefined} */
let loading;

/** @returns {any} the library, undefined until it is loaded */
export const uPlot = () => /** @type {any} */ (window).uPlot;

/** @returns {Promise<void>} */
export function loadPlotter() {
  loading ??= new Promise((done, failed) => {
    const script = document.createElement('script');
    script.src = ADDRESS;
    script.addEventListener('load', () => done());
    script.addEventListener('error', () =>
      failed(new Error('The curves cannot be drawn: part of the page is missing. Reload the page.')),
    );
    document.head.append(script);
  });
  return loading;
}

/**
 * @param {HTMLElement} place
 * @param {readonly string[]} names
 * @param {{width: number, seek: (seconds: number) => void, zoomed: (range: {from: number, to: number}) => void}} options
 * @returns {any} a plot; undefined if the library is not loaded yet or there is no space
 */
export function newPlot(place, names, { width, seek, zoomed }) {
  place.replaceChildren();
  if (!uPlot() || width < 50 || names.length === 0) {
    return undefined;
  }
  const style = getComputedStyle(place);
  const colour = (/** @type {string} */ name) => style.getPropertyValue(name).trim();
  const shown = { moment: 0 };
  const hooks = {
    draw: [(/** @type {any} */ drawn) => drawMoment(drawn, shown.moment, colour('--ink'))],
    setSelect: [(/** @type {any} */ chosen) => zoomTo(chosen, zoomed)],
  };
  const options = { ...LOOK, width, axes: axes(colour), series: [{}, ...names.map(seriesIn(colour))], hooks };
  const plot = new (uPlot())(options, [[], ...names.map(() => [])], place);
  listenToClicks(plot, seek);
  plot.showMoment = (/** @type {number} */ seconds) => {
    shown.moment = seconds;
  };
  return plot;
}

/** @param {(name: string) => string} colour */
function seriesIn(colour) {
  return (/** @type {string} */ label, /** @type {number} */ i) => ({
    label,
    stroke: () => colour(`--curve-${i % COLOURS}`),
    width: 1.5,
    spanGaps: true,
    points: { show: false },
    dash: i < COLOURS ? undefined : [6, 3],
  });
}

/** Zooms to the selected range of a plot. @param {any} plot @param {(range: {from: number, to: number}) => void} zoomed */
function zoomTo(plot, zoomed) {
  const { left, width } = plot.select;
  if (width > MIN_DRAG_PIXELS) {
    zoomed({ from: plot.posToVal(left, 'x'), to: plot.posToVal(left + width, 'x') });
  }
  plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
}

/** Distinguishes clicks from drags: a click moves the cursor, a drag zooms. @param {any} plot @param {(seconds: number) => void} seek */
function listenToClicks(plot, seek) {
  let pressedAt = 0;
  plot.over.addEventListener('pointerdown', (/** @type {PointerEvent} */ event) => {
    pressedAt = event.clientX;
  });
  plot.over.addEventListener('click', (/** @type {MouseEvent} */ event) => {
    if (Math.abs(event.clientX - pressedAt) < MIN_DRAG_PIXELS) {
      seek(plot.posToVal(event.offsetX, 'x'));
    }
  });
}

/** Returns axes in the colours of the theme. @param {(name: string) => string} colour */
export function axes(colour) {
  const axis = {
    stroke: () => colour('--faint'),
    grid: { stroke: () => colour('--edge'), width: 1 },
    ticks: { show: false },
    font: '12px system-ui, sans-serif',
  };
  return [
    { ...axis, size: 22, gap: 2 },
    { ...axis, size: 46, gap: 2, space: 24 },
  ];
}

/**
 * Returns the range of the vertical axis with margins; a constant curve is centred.
 *
 * @param {any} _
 * @param {number | null} min
 * @param {number | null} max
 */
export function roomy(_, min, max) {
  const [low, high] = [min ?? 0, max ?? 1];
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
