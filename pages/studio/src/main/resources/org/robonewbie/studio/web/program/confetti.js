/** A small celebration: confetti over the picture, unless the user prefers reduced motion. */
import { byId, element } from '../panels/elements.js';

const PIECES = 60;
const COLOURS = 6;
const SECONDS = 3.5;

export function celebrate() {
  if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
    return;
  }
  const pieces = Array.from({ length: PIECES }, (_, i) => {
    const piece = element('i', { class: `curve-${i % COLOURS}` });
    piece.style.left = `${100 * Math.random()}%`;
    piece.style.animationDelay = `${Math.random()}s`;
    return piece;
  });
  const place = element('div', { class: 'confetti', 'aria-hidden': 'true' }, ...pieces);
  byId('field-room').append(place);
  setTimeout(() => place.remove(), 1000 * SECONDS);
}
