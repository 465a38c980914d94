/** Sliders for the tunable numbers of the running program: they take effect immediately, and the values can be written into the program. */
import { button, element, setText } from '../panels/elements.js';
import { ChosenNumbers, numberText, stepOf, withDefault } from '../state/program/sliders.js';

/** @typedef {import('../state/program/sliders.js').DeclaredNumber} DeclaredNumber */
/** @typedef {{line: HTMLElement, range: HTMLInputElement, shown: HTMLElement, keep: HTMLElement, number: DeclaredNumber}} Slider */

export class SliderController {
  #chosen = new ChosenNumbers();
  /** @type {Map<string, Slider>} */
  #sliders = new Map();

  /**
   * @param {HTMLElement} place
   * @param {object} program
   * @param {(name: string, value: number) => void} program.tune
   * @param {() => string} program.text
   * @param {(text: string) => void} program.write replaces the program's text
   */
  constructor(place, program) {
    this.place = place;
    this.program = program;
  }

  /** Called when the program is restarted. */
  begin() {
    this.#sliders.clear();
    this.place.replaceChildren();
  }

  /** Called when another program is shown. */
  forget() {
    this.begin();
    this.#chosen.forget();
  }

  /** @param {DeclaredNumber} number number declared by the running program */
  receive(number) {
    const slider = this.#sliders.get(number.name) ?? this.#add(number);
    slider.number = number;
    const pendingValue = this.#chosen.pendingValue(number, performance.now());
    if (pendingValue !== undefined) {
      this.program.tune(number.name, pendingValue);
    }
    this.#show(slider, this.#chosen.shown(number));
  }

  /** @param {DeclaredNumber} number */
  #add(number) {
    const { name, min, max } = number;
    const range = element('input', {
      type: 'range',
      min: String(min),
      max: String(max),
      step: String(stepOf(number)),
      'aria-label': name,
    });
    const shown = element('output');
    const resetButton = button('⟲', `Reset to ${numberText(number.defaultValue)}, the value in the program`, () =>
      this.#choose(slider, slider.number.defaultValue),
    );
    const keep = button('Write to the program', `Changes number("${name}", …) in the editor`, () =>
      this.#write(slider),
    );
    const line = element(
      'div',
      { class: 'program-slider' },
      element('span', {}, name),
      range,
      shown,
      resetButton,
      keep,
    );
    /** @type {Slider} */
    const slider = { line, range, shown, keep, number };
    range.addEventListener('input', () => this.#choose(slider, Number(range.value)));
    this.#sliders.set(name, slider);
    this.place.append(line);
    return slider;
  }

  /** @param {Slider} slider @param {number} value */
  #choose(slider, value) {
    this.#chosen.choose(slider.number, value, performance.now());
    this.program.tune(slider.number.name, value);
    this.#show(slider, value);
  }

  /** @param {Slider} slider @param {number} value */
  #show({ range, shown, keep, number }, value) {
    if (Number(range.value) !== value) {
      range.value = String(value);
    }
    setText(shown, numberText(value));
    keep.hidden = value === number.defaultValue || withDefault(this.program.text(), number.name, value) === undefined;
  }

  /** @param {Slider} slider */
  #write({ number }) {
    const text = withDefault(this.program.text(), number.name, this.#chosen.shown(number));
    if (text !== undefined) {
      this.program.write(text);
    }
  }
}
