/**
 * What a careless hand does in a page, drawn from a seed: clicks, drags, keys, the wheel, and texts in fields. rooms/clicks.test.js
 * loads it. Files that would be chosen or offered are passed over, since no person is there to answer the browser's windows.
 */

const KEYS = [
  ...'abcdefghijklmnopqrstuvwxyz0123456 +-<>?.,[]',
  ...['Enter', 'Escape', 'Delete', 'Backspace', 'Home', 'End', 'PageUp', 'PageDown'],
  ...['ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown'],
];
const TEXTS = ['12,5', '', '-', '1e9', 'NaN', 'abc', '-9999', '45', '1e-7', 'Infinity', '../x', '<b>', 'a'.repeat(300)];
const CONTROLS = 'button, input, select, summary, [tabindex], a[href^="#"]';
const STEPS_PER_BREATH = 20;
const BREATH_MILLISECONDS = 10;

HTMLInputElement.prototype.click = function click() {
  if (this.type === 'file') {
    this.dispatchEvent(new Event('cancel'));
  } else {
    HTMLElement.prototype.click.call(this);
  }
};
HTMLAnchorElement.prototype.click = function click() {
  if (this.getAttribute('href')?.startsWith('#') && !this.download) {
    location.hash = this.getAttribute('href');
  }
};

/** Xorshift32. */
class Chance {
  constructor(seed) {
    this.state = seed >>> 0 || 1;
  }

  part() {
    this.state ^= this.state << 13;
    this.state >>>= 0;
    this.state ^= this.state >>> 17;
    this.state ^= this.state << 5;
    this.state >>>= 0;
    return this.state / 2 ** 32;
  }

  below(end) {
    return Math.floor(end * this.part());
  }

  one(list) {
    return list[this.below(list.length)];
  }

  held() {
    return { ctrlKey: this.part() < 0.15, shiftKey: this.part() < 0.2, altKey: this.part() < 0.1 };
  }

  place() {
    return { clientX: innerWidth * this.part(), clientY: innerHeight * this.part() };
  }
}

const all = { bubbles: true, cancelable: true, composed: true };
const pointer = { pointerId: 1, isPrimary: true, pointerType: 'mouse', button: 0 };
const under = ({ clientX, clientY }) => document.elementFromPoint(clientX, clientY) ?? document.body;

function use(control, chance) {
  if (control instanceof HTMLSelectElement) {
    control.selectedIndex = chance.below(control.options.length);
    control.dispatchEvent(new Event('change', all));
  } else if (control.type === 'range') {
    control.value = String(Number(control.min) + chance.part() * (Number(control.max) - Number(control.min)));
    control.dispatchEvent(new Event('input', all));
  } else if (control instanceof HTMLInputElement && !['checkbox', 'radio', 'file'].includes(control.type)) {
    control.focus();
    control.value = chance.one(TEXTS);
    control.dispatchEvent(new Event('input', all));
    if (chance.part() < 0.6) {
      control.blur();
      control.dispatchEvent(new Event('change', all));
    }
  } else {
    control.focus();
    control.click();
  }
}

function drag(chance) {
  const held = chance.held();
  let place = chance.place();
  const target = under(place);
  const send = (type, buttons) =>
    target.dispatchEvent(new PointerEvent(type, { ...all, ...pointer, ...place, ...held, buttons }));
  send('pointermove', 0);
  send('pointerdown', 1);
  const moves = chance.below(4);
  for (let i = 0; i < moves; i++) {
    place = {
      clientX: place.clientX + 300 * (chance.part() - 0.5),
      clientY: place.clientY + 300 * (chance.part() - 0.5),
    };
    send('pointermove', 1);
  }
  send('pointerup', 0);
  if (moves === 0) {
    target.dispatchEvent(new MouseEvent(chance.part() < 0.8 ? 'click' : 'dblclick', { ...all, ...place, ...held }));
  }
}

function press(chance) {
  const key = chance.one(KEYS);
  const code = /^[a-z]$/.test(key) ? `Key${key.toUpperCase()}` : key;
  const event = { ...all, ...chance.held(), key, code };
  (document.activeElement ?? document.body).dispatchEvent(new KeyboardEvent('keydown', event));
  (document.activeElement ?? document.body).dispatchEvent(new KeyboardEvent('keyup', event));
}

function turnWheel(chance) {
  const place = chance.place();
  const deltaY = 800 * (chance.part() - 0.5);
  under(place).dispatchEvent(new WheelEvent('wheel', { ...all, ...place, ...chance.held(), deltaY }));
}

function step(chance, controls) {
  const kind = chance.part();
  if (kind < 0.4) {
    const control = chance.one(controls);
    if (control?.isConnected && !control.disabled && control.checkVisibility()) {
      use(control, chance);
    }
  } else if (kind < 0.6) {
    drag(chance);
  } else if (kind < 0.68) {
    turnWheel(chance);
  } else {
    press(chance);
  }
}

/** Does so many steps and returns to the room now and then. */
async function fuzz(seed, count, room) {
  const chance = new Chance(seed);
  const breath = () => new Promise((done) => setTimeout(done, BREATH_MILLISECONDS));
  for (let i = 0; i < count; i += STEPS_PER_BREATH) {
    const controls = [...document.querySelectorAll(CONTROLS)];
    for (let k = 0; k < STEPS_PER_BREATH; k++) {
      step(chance, controls);
    }
    if (!location.hash.startsWith(room.split('/')[0]) && chance.part() < 0.5) {
      location.hash = room;
    }
    await breath();
  }
}
window.fuzz = fuzz;
