/** SVG drawing of a small pitch from above. */
import { shape } from './drawing.js';

/**
 * @param {number} length length of the pitch in metres
 * @param {number} width
 * @param {...Node} content content in metres, with y pointing down
 */
export function pitchSheet(length, width, ...content) {
  const line = { class: 'line' };
  return shape(
    'svg',
    {
      viewBox: `${-length / 2 - 1} ${-width / 2 - 1} ${length + 2} ${width + 2}`,
      class: 'pitch-sheet',
      'aria-hidden': 'true',
    },
    shape('rect', { x: -length / 2, y: -width / 2, width: length, height: width, ...line }),
    shape('line', { y1: -width / 2, y2: width / 2, ...line }),
    shape('circle', { r: length / 12, ...line }),
    ...content,
  );
}
