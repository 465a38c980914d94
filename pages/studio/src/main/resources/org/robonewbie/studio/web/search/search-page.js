/** Page that shows a running search for better values of an agent's parameters. */
import { ReportPage } from '../live/report-page.js';
import { byId, element, setText } from '../panels/elements.js';
import { themeSwitch } from '../panels/theme.js';
import { loadPlotter } from '../robot/plotter.js';
import {
  bars,
  facts,
  initialSearch,
  sentence,
  stepCurve,
  valueCurves,
  withNews,
  withoutLine,
} from '../state/search.js';
import { searchPlot } from './search-plot.js';

const MAX_NUMBERS = 60;

const page = new ReportPage('live-search', initialSearch(), { received: withNews, lost: withoutLine }, draw);

await loadPlotter();
const valuePlot = searchPlot(byId('value-plot'), [
  { label: 'best', colour: '--curve-0', points: true },
  { label: 'mean', colour: '--curve-1' },
  { label: 'start', colour: '--faint', dash: [6, 4] },
]);
const stepPlot = searchPlot(byId('step-plot'), [{ label: 'sigma', colour: '--curve-2' }]);

function draw() {
  const search = page.known;
  const { task, numbers, place, phase } = search;
  if (task) {
    setText(
      byId('task'),
      `${task.subject}: ${task.objective} (${task.isLargerBetter ? 'higher' : 'lower'} is better), ${task.method}`,
    );
    setText(byId('value-title'), `${task.objective} in ${task.unit}`);
    byId('share').setAttribute('value', String(search.rounds.length / task.rounds));
  }
  byId('facts').replaceChildren(
    ...facts(search).map(([name, value]) => element('div', {}, element('dt', {}, name), element('dd', {}, value))),
  );
  const { tone, text } = sentence(search);
  byId('outcome').dataset.tone = tone;
  setText(byId('outcome'), text);
  const look = byId('look');
  look.hidden = place === '';
  look.setAttribute('href', `./${place}`);
  setText(look, phase === 'ended' ? 'Show the resulting motion' : 'Show the current motion');
  valuePlot.setData(valueCurves(search));
  stepPlot.setData(stepCurve(search));
  const shown = bars(numbers, MAX_NUMBERS);
  setText(
    byId('number-count'),
    numbers.length > shown.length ? `(the ${shown.length} of ${numbers.length} numbers that changed most)` : '',
  );
  byId('numbers').replaceChildren(...shown.map(numberRow));
}

/** @param {ReturnType<typeof bars>[number]} number */
function numberRow({ name, unit, start, value, at, half }) {
  const part = (/** @type {string} */ kind, /** @type {number} */ from, /** @type {number} */ to) => {
    const bar = element('i', { class: kind });
    bar.style.left = `${100 * Math.min(from, to)}%`;
    bar.style.width = kind === 'start' ? '' : `${100 * Math.abs(to - from)}%`;
    return bar;
  };
  const words = (/** @type {number} */ x) => String(Number(x.toPrecision(4)));
  const range = element(
    'span',
    { class: 'range' },
    part('spread', at - half, at + half),
    part('change', 0.5, at),
    part('start', 0.5, 0.5),
  );
  const text = `${words(start)} → ${words(value)}${unit === '' ? '' : ` ${unit}`}`;
  return element(
    'div',
    { class: 'number', title: text },
    element('span', {}, name),
    element('span', { class: 'values' }, text),
    range,
  );
}

themeSwitch(page.options.get('theme'), () => {
  valuePlot.redraw(false);
  stepPlot.redraw(false);
});
page.open();

/** Exposed in the browser's console for tests and debugging. */
Object.assign(window, {
  search: {
    get state() {
      return page.known;
    },
    valuePlot,
    stepPlot,
  },
});
