/** Fields for numbers: what is typed is taken once, by Enter, when the field is left, or before anything else is done. */
import { element } from '../panels/elements.js';
import { numberOf } from '../state/numbers.js';

/** Which field the person writes in, for an order that must not miss what was typed. */
const TYPED = 'typed';

/**
 * @param {Record<string, string>} attributes
 * @param {number} most that is taken, and its negative
 * @param {(value: number) => void} take
 * @param {(text: string) => void} refuse hears what is not such a number
 */
export function numberField(attributes, most, take, refuse) {
  const field = element('input', { type: 'text', ...attributes });
  const commit = () => {
    if (field.dataset[TYPED] !== 'yes') {
      return;
    }
    field.dataset[TYPED] = '';
    const value = numberOf(field.value);
    if (value !== undefined && Math.abs(value) <= most) {
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

/** Shows a number, but never over what the person is typing. @param {HTMLInputElement} field @param {string} text */
export function showNumber(field, text) {
  if (field.dataset[TYPED] !== 'yes' && field.value !== text) {
    field.value = text;
  }
}

/** Takes what is typed and not yet taken. A browser itself does so only when the field is left, which keys do not do. */
export function takeTyped() {
  document.querySelector(`[data-${TYPED}='yes']`)?.dispatchEvent(new Event('change'));
}
