/**
 * Measures the functions of the page's scripts like the methods of our Java: lines between the braces. Fails where one of
 * ten is longer than 18 lines or a single one longer than 45, and names the longest. Run it with `npm run lengths`.
 */
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import process from 'node:process';
import ts from 'typescript';

const WEB = 'src/main/resources/org/robonewbie/studio/web';
const NINE_OF_TEN = 18;
const LONGEST = 45;

const functions = readdirSync(WEB, { recursive: true })
  .map(String)
  .filter((name) => name.endsWith('.js') && !name.startsWith('vendor'))
  .flatMap(functionsOf)
  .sort((one, other) => one.lines - other.lines);
const at = (/** @type {number} */ share) => functions[Math.floor(share * (functions.length - 1))].lines;
const longest = at(1);

console.log(
  `${functions.length} functions: median ${at(0.5)} lines, nine of ten at most ${at(0.9)}, longest ${longest}.`,
);
if (functions.length === 0 || at(0.9) > NINE_OF_TEN || longest > LONGEST) {
  console.error(`At most ${NINE_OF_TEN} for nine of ten and ${LONGEST} for all are allowed. The longest:`);
  functions.slice(-20).forEach(({ lines, place }) => console.error(`  ${lines}  ${place}`));
  process.exitCode = 1;
}

/** @param {string} name of a script */
function functionsOf(name) {
  const source = ts.createSourceFile(name, readFileSync(join(WEB, name), 'utf8'), ts.ScriptTarget.Latest, true);
  const line = (/** @type {number} */ position) => source.getLineAndCharacterOfPosition(position).line;
  /** @type {Array<{lines: number, place: string}>} */
  const found = [];
  const visit = (/** @type {ts.Node} */ node) => {
    if (ts.isFunctionLike(node) && 'body' in node && node.body && ts.isBlock(node.body)) {
      const first = line(node.body.getStart());
      found.push({ lines: Math.max(0, line(node.body.end) - first - 1), place: `${name}:${first + 1}` });
    }
    ts.forEachChild(node, visit);
  };
  visit(source);
  return found;
}
