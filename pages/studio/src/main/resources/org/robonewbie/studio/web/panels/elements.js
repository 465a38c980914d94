/** Helpers that create and change page elements. */

/** How long an offered file stays available for download. */
const OFFER_MILLISECONDS = 20_000;

/**
 * Creates an element.
 *
 * @template {keyof HTMLElementTagNameMap} K
 * @param {K} tag
 * @param {Record<string, string>} [attributes]
 * @param {...(Node | string)} children
 * @returns {HTMLElementTagNameMap[K]}
 */
export function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

/**
 * Creates a push button.
 *
 * @param {string} text
 * @param {string} hint tooltip
 * @param {() => void} action
 * @param {Record<string, string>} [attributes]
 */
export function button(text, hint, action, attributes = {}) {
  const made = element('button', { type: 'button', title: hint, ...attributes }, text);
  made.addEventListener('click', action);
  return made;
}

/**
 * Creates a drop-down list.
 *
 * @param {Record<string, string>} attributes
 * @param {ReadonlyArray<readonly [value: string, text: string]>} entries
 * @param {(value: string) => void} chosen
 */
export function choice(attributes, entries, chosen) {
  const made = element('select', attributes);
  setEntries(made, entries);
  made.addEventListener('change', () => chosen(made.value));
  return made;
}

/**
 * @param {HTMLSelectElement} list
 * @param {ReadonlyArray<readonly [value: string, text: string]>} entries
 */
export function setEntries(list, entries) {
  list.replaceChildren(...entries.map(([value, text]) => element('option', { value }, text)));
}

/**
 * Creates a labelled check box.
 *
 * @param {string} id
 * @param {string} text
 * @param {string} hint
 * @param {(on: boolean) => void} changed
 */
export function check(id, text, hint, changed) {
  const box = element('input', { type: 'checkbox', id });
  box.addEventListener('change', () => changed(box.checked));
  return { box, label: element('label', { class: 'check', title: hint }, box, text) };
}

/**
 * Offers a file for download.
 *
 * @param {string} name name of the file
 * @param {string | Blob} content
 * @param {string} [type] MIME type of string content
 */
export function offer(name, content, type = 'text/plain') {
  const address = URL.createObjectURL(typeof content === 'string' ? new Blob([content], { type }) : content);
  element('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), OFFER_MILLISECONDS);
}

/**
 * Sets the text of an element only if it differs, to avoid a needless layout.
 *
 * @param {Element} target
 * @param {string} text
 */
export function setText(target, text) {
  if (target.textContent !== text) {
    target.textContent = text;
  }
}

/**
 * Returns the page element with this id, which must exist.
 *
 * @param {string} id
 * @returns {HTMLElement}
 */
export function byId(id) {
  const found = document.getElementById(id);
  if (!found) {
    throw new Error(`The page has no element "${id}".`);
  }
  return found;
}
