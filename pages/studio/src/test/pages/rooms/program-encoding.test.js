/** Saving in the program editor changes only the edited bytes, in any encoding, in Chromium and in Firefox. */
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { launch } from '../browser.js';
import { atEnd, slow } from '../tests.js';
import { EDITOR, openStudio } from '../user.js';

const PROGRAM = '// Grüße\r\npublic class Lat {\r\n    // ß\r\n}\r\n';
const BIG_ENDIAN = (text) => Buffer.from(text, 'utf16le').swap16();

/** Encodings with functions that return the bytes of a text. */
const ENCODINGS = {
  'Windows-1252': (text) => Buffer.from(text, 'latin1'),
  'UTF-8': (text) => Buffer.from(text),
  'UTF-8 with a byte order mark': (text) => Buffer.from(`\uFEFF${text}`),
  'little-endian UTF-16': (text) => Buffer.from(`\uFEFF${text}`, 'utf16le'),
  'big-endian UTF-16': (text) => BIG_ENDIAN(`\uFEFF${text}`),
};
const latin = ENCODINGS['Windows-1252'];

/** Bytes in hexadecimal, and why they cannot be read. */
const UNDECODABLE = {
  '6f6b0a8161': 'line 2 is neither UTF-8 nor Windows-1252',
  c3bcc3bc0aff: 'line 2 is not UTF-8',
  61006200: 'zero byte',
  fffe610a00: 'ends within a UTF-16 character',
};

async function openLat(t, bytes, { files = {}, browser } = {}) {
  const room = 'program/Lat.java';
  const studio = await openStudio(t, { room, files: { 'Lat.java': bytes, ...files }, browser });
  return { ...studio, lat: () => readFileSync(join(studio.folder, 'Lat.java')) };
}

async function firefox(t) {
  const browser = await launch({ inFirefox: true });
  atEnd(t, () => browser.close());
  return browser;
}

/** Clicks the editor and returns it; Firefox finds nothing in a shadow tree by its role. */
async function clicksTheEditor({ page }) {
  const editor = await page.waitForSelector(`>>> [aria-label="${EDITOR}"]`, { visible: true });
  await editor.click();
  return editor;
}

/** Types at the end of the program and saves it. */
async function typesAndSaves({ user, lat }, text, saved) {
  await clicksTheEditor(user);
  await user.presses('Control+End');
  await user.types(text);
  await user.presses('Control+s');
  await user.until(
    () => lat().equals(saved),
    () => `saves ${saved}, but the file is ${lat()}`,
  );
}

for (const [encoding, bytes] of Object.entries(ENCODINGS)) {
  slow(`only typed text changes in a file in ${encoding}`, async (t) => {
    const studio = await openLat(t, bytes(PROGRAM));
    await studio.user.reads('textbox', EDITOR, PROGRAM.replaceAll('\r\n', '\n').trim());

    await typesAndSaves(studio, '// x', bytes(`${PROGRAM}// x`));
  });
}

slow('an inferred encoding is shown and can be changed', async (t) => {
  const studio = await openLat(t, latin(PROGRAM));
  const { user, lat } = studio;
  await user.sees('line 1 is not UTF-8 and was read as Windows-1252: "// Grüße"');

  await user.clicks('button', 'Save as UTF-8');

  await user.seesNo('was read as Windows-1252');
  await user.until(() => lat().equals(Buffer.from(PROGRAM)));
  await typesAndSaves(studio, '// ä', Buffer.from(`${PROGRAM}// ä`));
});

slow('a character that cannot be encoded converts the file to UTF-8', async (t) => {
  const studio = await openLat(t, latin(PROGRAM));

  await typesAndSaves(studio, '// Привет', Buffer.from(`${PROGRAM}// Привет`));

  await studio.user.sees('Lat.java is now saved as UTF-8, because Windows-1252 cannot represent all of its characters');
});

for (const [hex, problem] of Object.entries(UNDECODABLE)) {
  slow(`a file that cannot be decoded is read-only: ${problem}`, async (t) => {
    const bytes = Buffer.from(hex, 'hex');
    const { user, folder, lat } = await openLat(t, bytes);
    await user.sees(problem);
    const shown = await user.reads('textbox', EDITOR);

    await user.clicks('textbox', EDITOR);
    await user.presses('x', 'Control+s');
    await user.clicks('button', '▶ Run');

    const save = await user.finds('button', 'Save');
    await user.until(() => save.evaluate((button) => button.disabled));
    assert.equal(await user.reads('textbox', EDITOR), shown);
    assert.deepEqual(lat(), bytes);
    assert.equal(existsSync(join(folder, '.studio/programs')), false);
  });
}

slow('in Firefox, Windows-1252 stays and undecodable bytes stay', async (t) => {
  const damaged = Buffer.from('6f6b0a81', 'hex');
  const files = { 'Odd.java': damaged };
  const studio = await openLat(t, latin(PROGRAM), { files, browser: await firefox(t) });
  const { user, folder } = studio;

  await typesAndSaves(studio, '// x', latin(`${PROGRAM}// x`));
  await user.fills('combobox', 'Program', 'own Odd.java');
  await user.sees('line 2 is neither UTF-8');
  const editor = await clicksTheEditor(user);
  await user.presses('x', 'Control+s');

  assert.match(await editor.evaluate((lines) => lines.innerText), /^ok/);
  assert.deepEqual(readFileSync(join(folder, 'Odd.java')), damaged);
});
