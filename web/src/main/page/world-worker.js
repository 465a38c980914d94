/**
 * The simulator and its agent, off the page's own thread. A message `{begin: {agent, seed}}` begins a world, `{ask: command}` passes on
 * what the page asks for, and `{call, with}` calls any function of the program. News are sent as texts, states as bytes.
 */
import { load } from './webassembly-loader.js';

const TURN_MILLISECONDS = 20;
const REPORT_MILLISECONDS = 200;
const SHORTEST_SECONDS = 0.001;

const program = load(new URL('robonewbie.wasm', import.meta.url).href);
let last = performance.now();
/** @type {ReturnType<typeof setInterval> | undefined} */
let turns;
/** @type {ReturnType<typeof setInterval> | undefined} */
let reports;

/** @param {any} exports functions of the program */
function turn(exports) {
  const now = performance.now();
  const seconds = Math.max(SHORTEST_SECONDS, (now - last) / 1000);
  last = now;
  exports.turn(seconds);
}

/** @param {any} exports @param {{agent: string, seed: number}} wanted */
function begin(exports, { agent, seed }) {
  exports.begin(agent, seed);
  postMessage({ begun: agent, agents: exports.agents().split(' ') });
  last = performance.now();
  turns ??= setInterval(() => attempt(() => turn(exports)), TURN_MILLISECONDS);
}

/** @param {any} exports @param {{classes: Int8Array[], seed: number}} wanted */
function beginProgram(exports, { classes, seed }) {
  for (const each of classes) {
    exports.takeClass(each);
  }
  const refusal = exports.beginProgram(seed);
  if (refusal) {
    postMessage({ refusal });
    return;
  }
  postMessage({ begun: '', agents: exports.agents().split(' ') });
  last = performance.now();
  turns ??= setInterval(() => attempt(() => turn(exports)), TURN_MILLISECONDS);
  reports ??= setInterval(() => attempt(() => postMessage({ run: exports.programRun() })), REPORT_MILLISECONDS);
}

/** @param {() => void} deed */
function attempt(deed) {
  try {
    deed();
  } catch (failure) {
    clearInterval(turns);
    postMessage({ failure: String(failure) });
  }
}

onmessage = async ({ data }) => {
  const exports = await program.then(
    (loaded) => loaded.exports,
    (failure) => postMessage({ failure: String(failure) }),
  );
  attempt(() => {
    if (data.begin) {
      begin(exports, data.begin);
    } else if (data.program) {
      beginProgram(exports, data.program);
    } else if (data.stopProgram) {
      exports.stopProgram();
    } else if (data.ask) {
      exports.ask(JSON.stringify(data.ask));
    } else {
      postMessage({ result: exports[data.call](...data.with) });
    }
  });
};
