/** Lists the faults at the displayed moment in an overlay on the motion editor's 3D view. */
import { element } from '../panels/elements.js';

/** @typedef {import('../state/motion/faults.js').Fault} Fault */

const MAX_ENTRIES = 5;

/** @param {HTMLElement} place container of the 3D view @returns {(faults: readonly Fault[]) => void} */
export function faultList(place) {
  const list = element('ul', { class: 'fault-list' });
  place.append(list);
  let shown = '';
  return (faults) => {
    const now = JSON.stringify(faults.map(({ kind, text }) => [kind, text]));
    if (now === shown) {
      return;
    }
    shown = now;
    const more = faults.length - MAX_ENTRIES;
    list.replaceChildren(
      ...faults.slice(0, MAX_ENTRIES).map(({ kind, text }) => element('li', { class: kind }, text)),
      ...(more > 0 ? [element('li', {}, `and ${more} more`)] : []),
    );
  };
}
