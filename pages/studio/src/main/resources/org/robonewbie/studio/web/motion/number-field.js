/** Number fields: typed text is committed once, on Enter, on blur, or before any other action. */
import { element } from '../panels/elements.js';
import { numberOf } from '../state/numbers.js';

/** Marks the field being edited, so that an action can commit its text first. */
const TYPED = 'typed';

/**
 * @param {Record<string, string>} attributes
 * @param {number} limit largest absolute value
 * @param {(value: number) => void} take
 * @param {(text: string) => void} refuse called with the text if it is not a valid number
 */
export function numberField(attributes, limit, take, refuse) {
  const field = element('input', { type: 'text', ...attributes });
  const commit = () => {
    if (field.dataset[TYPED] !== 'yes') {
      return;
    }
    field.dataset[TYPED] = '';
    const value = numberOf(field.value);
    if (value !== undefined && Math.abs(value) <= limit) {
      take(value);
    } else {
      refuse(field.value);
    }
  };
  field.addEventListener('input', () => {
    field.dataset[TYPED] = 'yes';
  });
  field.addEventListener('change', commit);
  field.addEventListener('keydown', (event) => event.key === 'Enter' && commit());
  return field;
}

/** Shows a number unless the user is typing in the field. @param {HTMLInputElement} field @param {string} text */
export function showNumber(field, text) {
  if (field.dataset[TYPED] !== 'yes' && field.value !== text) {
    field.value = text;
  }
}

/** Commits typed text. Browsers do so only on blur, which keyboard actions do not cause. */
export function takeTyped() {
  document.querySelector(`[data-${TYPED}='yes']`)?.dispatchEvent(new Event('change'));
}
