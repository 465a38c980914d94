/** Helpers that create SVG elements. */

const SVG = 'http://www.w3.org/2000/svg';

/**
 * @param {string} name
 * @param {Record<string, string | number>} attributes
 * @param {...Node} children
 * @returns {SVGElement}
 */
export function shape(name, attributes = {}, ...children) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) {
    made.setAttribute(key, String(value));
  }
  made.append(...children);
  return made;
}

/** @param {string} content @param {number} x @param {number} y @param {string} kind */
export function label(content, x, y, kind) {
  const made = shape('text', { x, y, class: kind });
  made.textContent = content;
  return made;
}

/** @param {string} content tooltip of the parent shape */
export function title(content) {
  const made = shape('title');
  made.textContent = content;
  return made;
}
