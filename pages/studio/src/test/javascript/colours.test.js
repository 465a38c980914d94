/** Contrast of the page and distinguishability of the teams, computed from the colours of the style sheet. */
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';

const STYLES = readFileSync(
  new URL('../../main/resources/org/robonewbie/studio/web/theme.css', import.meta.url),
  'utf8',
);

/** Minimum contrast ratios of the web's accessibility guidelines (WCAG 2.2, 1.4.3 for text, 1.4.11 for shapes). */
const LETTERS = 4.5;
const SHAPES = 3;

/**
 * The camera's picture is drawn in degrees (120 are 280 pixels), the surroundings and the soles in metres (14 are 280 pixels, 0.26 are
 * 130): at least 12 pixels.
 */
const LETTERS_IN_DRAWINGS = ['font-size: 5.4px', 'font-size: 0.6px', 'font-size: 0.024px'];

/** Colour blindness: linear red, green and blue without one kind of cone (Machado, Oliveira and Fernandes 2009, severity 1). */
const BLINDNESS = {
  protanopia: [
    [0.152286, 1.052583, -0.204868],
    [0.114503, 0.786281, 0.099216],
    [-0.003882, -0.048116, 1.051998],
  ],
  deuteranopia: [
    [0.367322, 0.860646, -0.227968],
    [0.280085, 0.672501, 0.047413],
    [-0.01182, 0.04294, 0.968881],
  ],
  tritanopia: [
    [1.255528, -0.076749, -0.178779],
    [-0.078411, 0.930809, 0.147602],
    [0.004733, 0.691367, 0.3039],
  ],
};

/** @param {'light' | 'dark'} theme @returns {Record<string, number[]>} red, green, blue from 0 to 1, and opacity */
function palette(theme) {
  const block =
    theme === 'light' ? STYLES.slice(STYLES.indexOf(':root {')) : STYLES.slice(STYLES.indexOf("[data-theme='dark']"));
  const rules = block.slice(0, block.indexOf('}'));
  return Object.fromEntries(
    [...rules.matchAll(/--([\w-]+): ([^;]+);/g)].map(([, name, value]) => [name, colour(value)]),
  );
}

/** @param {string} text */
function colour(text) {
  if (text.startsWith('#')) {
    const digits =
      text.length === 4
        ? [...text.slice(1)].map((digit) => digit + digit)
        : [1, 3, 5].map((at) => text.slice(at, at + 2));
    return [...digits.map((pair) => parseInt(pair, 16) / 255), 1];
  }
  const [red, green, blue, percent] = [...text.matchAll(/[\d.]+/g)].map(Number);
  return [red / 255, green / 255, blue / 255, percent / 100];
}

/** @param {number[]} front @param {number[]} behind colour behind it */
const over = (front, behind) => [0, 1, 2].map((i) => front[i] * front[3] + behind[i] * (1 - front[3]));

/** @param {number[]} rgb */
const linear = (rgb) =>
  rgb.slice(0, 3).map((value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));

/** @param {number[]} rgb */
function luminance(rgb) {
  const [red, green, blue] = linear(rgb);
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}

/** @param {number[]} one @param {number[]} other */
function contrast(one, other) {
  const [low, high] = [luminance(one), luminance(other)].sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
}

/** @param {number[]} light linear red, green and blue @returns {number[]} CIE L*a*b* */
function lab([red, green, blue]) {
  const f = (/** @type {number} */ t) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116);
  const x = f((0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.95047);
  const y = f(0.2126 * red + 0.7152 * green + 0.0722 * blue);
  const z = f((0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.08883);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}

for (const theme of /** @type {const} */ (['light', 'dark'])) {
  const colours = palette(theme);
  const grass = theme === 'light' ? colour('#5cab69') : colour('#2d6a3c');
  const grounds = {
    page: colours.page,
    panel: over(colours.panel, colours.page),
    'panel over grass': over(colours.panel, grass),
    field: colours.field,
  };

  test(`text has enough contrast on every background, ${theme}`, () => {
    for (const [ground, behind] of Object.entries(grounds)) {
      for (const name of ['ink', 'faint', 'accent', 'trouble', 'warning']) {
        const ratio = contrast(colours[name], behind);
        assert.ok(ratio >= LETTERS, `${name} on ${ground}: ${ratio.toFixed(2)}`);
      }
    }
    assert.ok(contrast(colours['on-accent'], colours.accent) >= LETTERS, 'on-accent on accent');
  });

  test(`lines of teams and curves have enough contrast, ${theme}`, () => {
    for (const name of Object.keys(colours).filter((each) => /^(left|right|curve-\d)$/.test(each))) {
      const ratio = contrast(colours[name], grounds.panel);
      assert.ok(ratio >= SHAPES, `${name}: ${ratio.toFixed(2)}`);
    }
  });

  test(`teams are distinguishable with colour blindness, ${theme}`, () => {
    for (const [kind, matrix] of Object.entries(BLINDNESS)) {
      const [left, right] = [colours.left, colours.right].map((each) => {
        const light = linear(each);
        return lab(
          matrix.map((row) =>
            Math.min(
              1,
              Math.max(
                0,
                row.reduce((sum, part, i) => sum + part * light[i], 0),
              ),
            ),
          ),
        );
      });
      const distance = Math.hypot(...left.map((value, i) => value - right[i]));
      assert.ok(distance > 50, `${kind}: ${distance.toFixed(0)}`);
    }
  });
}

test('no text is smaller than twelve pixels', () => {
  const folder = new URL('../../main/resources/org/robonewbie/studio/web/', import.meta.url);
  for (const file of ['theme', 'layout', 'messages', 'motion', 'puppet', 'replay', 'robot', 'time-line']) {
    const sizes = [
      ...readFileSync(new URL(`${file}.css`, folder), 'utf8').matchAll(/font(?:-size)?:[^;]*?([\d.]+)(px|rem|em)/g),
    ];
    for (const [rule, size, unit] of sizes.filter(([each]) => !LETTERS_IN_DRAWINGS.includes(each))) {
      assert.ok(Number(size) * (unit === 'px' ? 1 : 15) >= 12, `${file}.css: ${rule}`);
    }
  }
});
