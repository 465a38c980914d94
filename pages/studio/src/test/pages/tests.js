/** Tests of the pages: quick ones for every build, and slow ones. */
import { test } from 'node:test';

const chosen = process.env.TESTS ?? 'all';
const LIMIT_MILLIS = 300_000;

/** Defines a test that shows the main use of a room in about a second. */
export const quick = tests('quick');

/** Defines a quick test that Firefox runs too. */
export const quickInBoth = tests('quick', 'firefox');

/** Defines a test that takes longer or varies a quick one. */
export const slow = tests('slow');

/** Defines a slow test that Firefox runs too. */
export const slowInBoth = tests('slow', 'firefox');

/** Defines a slow test that takes a picture for the documentation, which has the name of its file in `docs/images`. */
export const picture = tests('slow', 'picture');

function tests(...kinds) {
  return (title, body) => {
    if (chosen === 'all' || kinds.includes(chosen)) {
      test(title, { timeout: LIMIT_MILLIS }, body);
    }
  };
}

const endings = new WeakMap();

/** Runs an action after a test. Actions run in the reverse order of their registration, all of them even if one fails. */
export function atEnd(t, action) {
  const actions = endings.get(t) ?? [];
  if (actions.length === 0) {
    endings.set(t, actions);
    t.after(() => runAll(actions.reverse()));
  }
  actions.push(action);
}

async function runAll([action, ...others]) {
  try {
    await action();
  } finally {
    if (others.length > 0) {
      await runAll(others);
    }
  }
}
