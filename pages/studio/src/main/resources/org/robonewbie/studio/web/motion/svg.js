/** Helpers that create SVG elements. */

const SVG = 'http://www.w3.org/2000/svg';

/**
 * @param {string} name
 * @param {Record<string, string | number>} [attributes] numbers are coordinates in pixels
 */
export function node(name, attributes = {}) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) {
    made.setAttribute(key, typeof value === 'number' ? String(Math.round(value * 10) / 10) : value);
  }
  return /** @type {SVGElement} */ (made);
}

/** @param {string} content @param {Record<string, string | number>} attributes */
export function text(content, attributes) {
  const made = node('text', attributes);
  made.textContent = content;
  return made;
}

/** @param {string} content tooltip */
export function title(content) {
  const made = node('title');
  made.textContent = content;
  return made;
}

/** @param {number} x @param {number} y @param {number} size half its width @returns {string} path of a diamond */
export function diamond(x, y, size) {
  return `M${x.toFixed(1)} ${(y - size).toFixed(1)}l${size} ${size}l${-size} ${size}l${-size} ${-size}z`;
}
