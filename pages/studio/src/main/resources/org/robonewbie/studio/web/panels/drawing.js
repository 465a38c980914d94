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
  setAttributes(made, attributes);
  made.append(...children);
  return made;
}

/** @param {Element} target @param {Record<string, string | number>} attributes */
export function setAttributes(target, attributes) {
  for (const [key, value] of Object.entries(attributes)) {
    target.setAttribute(key, String(value));
  }
}

/** @param {string} content @param {number} x @param {number} y @param {string} kind CSS class */
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

/** @param {number} x @param {number} y @param {number} size half its width @returns {string} path of a diamond */
export function diamond(x, y, size) {
  return `M${x.toFixed(1)} ${(y - size).toFixed(1)}l${size} ${size}l${-size} ${size}l${-size} ${-size}z`;
}
