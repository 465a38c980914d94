/** The solutions of the exercises. */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

/** Folder of the solutions, which also has other files. */
export const SOLUTIONS = fileURLToPath(
  new URL('../../../../../course/exercises/src/test/java/org/robonewbie/exercises/solution', import.meta.url),
);

/** Returns a solution, such as `Kick.java`, as a student types it. */
export function solution(file) {
  return readFileSync(join(SOLUTIONS, file), 'utf8').replace(/package [^;]*;\s*/, '');
}
