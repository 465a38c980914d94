/**
 * Web worker that runs the simulator and the agents. A message such as `{begin: {agents, seed}}` or `{ask: command}` contains the name of
 * an action and its argument. The worker sends messages as strings or objects, and states as bytes.
 */
import { load } from './webassembly-loader.js';

const TURN_MILLISECONDS = 20;
const REPORT_MILLISECONDS = 200;
const MIN_SECONDS = 0.001;

/**
 * Whether to load the program that executes user code. This depends on the worker's name rather than a query, because a service worker may
 * remove the query from the address.
 */
const FOR_PROGRAMS = self.name === 'programs';

const program = load(new URL(FOR_PROGRAMS ? 'programs/robonewbie.wasm' : 'field.wasm', import.meta.url).href);
let last = performance.now();
/** @type {ReturnType<typeof setInterval> | undefined} */
let turns;
/** @type {ReturnType<typeof setInterval> | undefined} */
let reports;

/** @param {any} exports functions of the program */
function turn(exports) {
  const now = performance.now();
  const seconds = Math.max(MIN_SECONDS, (now - last) / 1000);
  last = now;
  exports.turn(seconds);
}

/** @param {any} exports */
function report(exports) {
  postMessage({ run: exports.programRun() });
}

/**
 * Called when a new world has started.
 *
 * @param {any} exports
 * @param {string} begun name of the agent; empty for a user program
 */
function announceStart(exports, begun) {
  postMessage({ begun, agents: exports.agents().split(' ') });
  last = performance.now();
  turns ??= setInterval(() => attempt(() => turn(exports)), TURN_MILLISECONDS);
  if (FOR_PROGRAMS) {
    reports ??= setInterval(() => attempt(() => report(exports)), REPORT_MILLISECONDS);
  }
}

/**
 * @param {any} exports
 * @param {Int8Array[]} classes
 * @param {() => string} start starts the program and returns why it cannot run here, or empty
 */
function startProgram(exports, classes, start) {
  take(exports, classes);
  const refusal = start();
  if (refusal) {
    postMessage({ refusal });
  } else {
    announceStart(exports, '');
  }
}

/** Replaces the running program and keeps the world. @param {any} exports @param {Int8Array[]} classes classes of the new program */
function swap(exports, classes) {
  take(exports, classes);
  const refusal = exports.swapProgram();
  last = performance.now();
  if (refusal) {
    postMessage({ refusal });
  } else {
    report(exports);
  }
}

/** @param {any} exports @param {Int8Array[]} classes */
function take(exports, classes) {
  for (const each of classes) {
    exports.takeClass(each);
  }
}

/** Actions that the page can request, by the name of the message. @type {Record<string, (exports: any, data: any) => void>} */
const ACTIONS = {
  begin: (exports, { agents, seed }) => {
    exports.begin(agents.join(' '), seed);
    announceStart(exports, agents[0]);
  },
  join: (exports, agent) => exports.join(agent),
  program: (exports, { classes, seed, others, keep }) => {
    if (keep && exports.isProgramRunning()) {
      swap(exports, classes);
    } else {
      startProgram(exports, classes, () => exports.beginProgram(seed, others.join(' ')));
    }
  },
  motions: (exports, motions) => {
    exports.forgetMotions?.();
    for (const [name, file] of motions) {
      exports.takeMotion?.(name, file);
    }
  },
  exercise: (exports, { id, request, classes }) => {
    take(exports, classes);
    const result = exports.answer('course', request);
    if (result.startsWith('{')) {
      announceStart(exports, '');
    }
    postMessage({ id, result });
  },
  stopProgram: (exports) => exports.stopProgram?.(),
  ask: (exports, command) => exports.ask(JSON.stringify(command)),
  call: (exports, { id, name, args }) => postMessage({ id, result: exports[name](...args) }),
};

/** @param {() => void} action */
function attempt(action) {
  try {
    action();
  } catch (failure) {
    clearInterval(turns);
    postMessage({ failure: String(failure) });
  }
}

onmessage = async ({ data }) => {
  const exports = await program.then(
    (loaded) => Object.assign(Object.create(loaded.exports), loaded.exports.FieldEdition),
    (failure) => postMessage({ failure: String(failure) }),
  );
  attempt(() => {
    for (const [name, argument] of Object.entries(data)) {
      ACTIONS[name](exports, argument);
    }
  });
};
