/** Measures how much of the 3D view is covered by panels, so that the camera can fit the scene into the rest. */
import { byId } from './elements.js';

/** Panels at the edges of the 3D view. */
const PANELS = /** @type {const} */ ([
  ['score-board', 'top'],
  ['side', 'right'],
  ['transport', 'bottom'],
  ['replay', 'bottom'],
]);

/**
 * @param {HTMLElement} stage container of the 3D view
 * @param {(covered: {left: number, top: number, right: number, bottom: number}) => void} changed
 */
export function watchFreeSpace(stage, changed) {
  const look = () => {
    const picture = stage.getBoundingClientRect();
    if (picture.height > 0) {
      changed(coveredBy(picture));
    }
  };
  const observer = new ResizeObserver(look);
  [stage, ...PANELS.map(([id]) => byId(id))].forEach((part) => observer.observe(part));
}

/** @param {DOMRect} picture */
function coveredBy(picture) {
  const covered = { left: 0, top: 0, right: 0, bottom: 0 };
  for (const [id, side] of PANELS) {
    const panel = byId(id).getBoundingClientRect();
    const depth = {
      top: panel.bottom - picture.top,
      right: picture.right - panel.left,
      bottom: picture.bottom - panel.top,
    };
    covered[side] = Math.max(covered[side], panel.height > 0 ? depth[side] : 0);
  }
  return covered;
}
