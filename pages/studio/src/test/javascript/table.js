/** Reads a table that the Java tests read as well. */
import { readFileSync } from 'node:fs';

const FOLDER = '../../../../../core/robot/src/test/resources/org/robonewbie/nao/text';

/** @param {string} file @returns {string[][]} */
export function tableOf(file) {
  return readFileSync(new URL(`${FOLDER}/${file}`, import.meta.url), 'utf8')
    .split('\n')
    .filter((line) => line !== '' && !line.startsWith('# '))
    .map((line) => line.split('\t').map(unescaped));
}

/** @param {string} cell */
function unescaped(cell) {
  const signs = /** @type {Record<string, string>} */ ({ '\\\\': '\\', '\\n': '\n', '\\r': '\r', '\\t': '\t' });
  return cell.replace(/\\u([0-9A-F]{4})|\\./g, (all, code) =>
    code ? String.fromCharCode(Number.parseInt(code, 16)) : signs[all],
  );
}
