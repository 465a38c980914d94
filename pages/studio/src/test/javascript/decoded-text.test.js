import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import {
  decodeText,
  encodeText,
  encodingFor,
  encodingNote,
  UndecodableText,
} from '../../main/resources/org/robonewbie/studio/web/state/decoded-text.js';
import { composedName, nameProblem } from '../../main/resources/org/robonewbie/studio/web/state/file-name.js';
import { tableOf } from './table.js';

const SAVE_AS_UTF_8 = 'Save it as UTF-8 (most editors: Save As, Encoding).';

/** @param {string} hexadecimal */
const bytesOf = (hexadecimal) => new Uint8Array(Buffer.from(hexadecimal, 'hex'));

for (const [what, bytes, encoding, content, note, typed, saved] of tableOf('decoded-texts.tsv')) {
  if (encoding === 'refused') {
    test(`refused with its line: ${what}`, () => {
      assert.throws(
        () => decodeText(bytesOf(bytes)),
        (/** @type {any} */ error) =>
          error instanceof UndecodableText &&
          error.line === Number(content) &&
          error.message === `line ${content} ${note}. ${SAVE_AS_UTF_8}`,
      );
    });
  } else {
    test(`round trip: ${what}`, () => {
      const text = decodeText(bytesOf(bytes));

      assert.equal(text.encoding + (text.hasByteOrderMark ? ' with mark' : ''), encoding);
      assert.equal(text.content, content);
      assert.equal(encodingNote(text), note === '-' ? '' : note + SAVE_AS_UTF_8);
      assert.deepEqual(encodeText(text, text.content), bytesOf(bytes));
      if (saved !== '-') {
        assert.deepEqual(encodeText(text, typed), bytesOf(saved));
        const again = { ...text, encoding: encodingFor(text, typed) };
        assert.deepEqual(encodeText(again, typed), bytesOf(saved));
      }
    });
  }
}

test('the page decodes bytes exactly like the robot', (context) => {
  const file = join(process.env.STUDIO_FRAME_FOLDER ?? '', 'texts.json');
  if (!existsSync(file)) {
    context.skip('run by Maven');
    return;
  }
  for (const { hex, said } of JSON.parse(readFileSync(file, 'utf8'))) {
    assert.equal(readAsSaid(bytesOf(hex)), said, hex);
  }
});

/** @param {Uint8Array} bytes */
function readAsSaid(bytes) {
  try {
    const text = decodeText(bytes);
    assert.deepEqual(encodeText(text, text.content), bytes);
    return `${text.encoding} ${text.hasByteOrderMark} ${text.content}\n${encodingNote(text)}`;
  } catch (error) {
    assert.ok(error instanceof UndecodableText);
    return error.message;
  }
}

for (const [name, problem] of tableOf('file-names.tsv')) {
  test(`problem of the name ${JSON.stringify(name)}`, () => {
    assert.equal(nameProblem(name), problem === '-' ? '' : problem);
  });
}

test('decomposed letters of macOS are composed', () => {
  assert.equal(composedName('gru\u0308ßen'), 'grüßen');
});
