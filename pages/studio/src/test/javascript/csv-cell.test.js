import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { csvCell } from '../../main/resources/org/robonewbie/studio/web/state/csv-cell.js';
import { tableOf } from '../../main/resources/org/robonewbie/studio/web/state/robot/traces.js';

const CELLS = new URL(
  '../../../../../core/robot/src/test/resources/org/robonewbie/nao/text/csv-cells.txt',
  import.meta.url,
);

/** @param {string} text */
function unescaped(text) {
  /** @type {Record<string, string>} */
  const signs = { '\\|': '|', '\\n': '\n', '\\r': '\r', '\\t': '\t', '\\u00a0': '\u00a0', '\\ufeff': '\ufeff' };
  return text.replaceAll(/\\(?:\||n|r|t|u00a0|ufeff)/g, (sign) => signs[sign]);
}

test('formulas are escaped like in the tables of the command line', () => {
  const lines = readFileSync(CELLS, 'utf8').trimEnd().split('\n');
  assert.ok(lines.length > 30);
  for (const line of lines) {
    const [text, cell] = line.split(/ \| ?/);
    assert.equal(csvCell(unescaped(text)), unescaped(cell), line);
  }
});

test('names of plotted values are escaped as cells', () => {
  const traces = { columns: () => [[0], [-1.5]] };
  assert.equal(tableOf(/** @type {any} */ (traces), ['=cmd()'], 0, 1), "seconds,'=cmd()\n0.00,-1.5\n");
});
