/** Small words for making and changing parts of the page. */

/** How long an offered file is kept for the browser to read. */
const OFFER_MILLISECONDS = 20_000;

/**
 * Makes an element.
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
 * Makes a push button.
 *
 * @param {string} text
 * @param {string} hint shown when the mouse rests on it
 * @param {() => void} action
 * @param {Record<string, string>} [attributes]
 */
export function button(text, hint, action, attributes = {}) {
  const made = element('button', { type: 'button', title: hint, ...attributes }, text);
  made.addEventListener('click', action);
  return made;
}

/**
 * Makes a list of which one entry is chosen.
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
 * Makes a box to tick with its words.
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
 * Lets the person save something as a file.
 *
 * @param {string} name of the file
 * @param {string | Blob} content
 * @param {string} [type] what kind of text it is
 */
export function offer(name, content, type = 'text/plain') {
  const address = URL.createObjectURL(typeof content === 'string' ? new Blob([content], { type }) : content);
  element('a', { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), OFFER_MILLISECONDS);
}

/**
 * Writes a text only if it differs, which spares the browser work.
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
 * Finds a part of the page that must be there.
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
