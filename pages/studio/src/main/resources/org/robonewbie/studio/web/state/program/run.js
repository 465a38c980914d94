/**
 * State of a program run, and detection of its robot. Pure.
 *
 * @typedef {'NONE' | 'STARTING' | 'RUNNING' | 'ENDED' | 'STOPPED' | 'REFUSED'} RunState
 * @typedef {{id: number, state: RunState, program: string, output: string, exitCode: number, entersFirst?: boolean}} ProgramRun
 */
import { fileName } from './remarks.js';

const CRASH = /^(Stopped at|Exception in thread) /m;
const PLACES = /([\w$]+\.java):(\d+)/g;
const JOINING = /^Joining the server at /;
const REPORT_TIME = /^\d+\.\d\d s: /;
const ENDLESS = /think\(\) has not returned.*?\(([^)]*)\)/s;

/** @type {ProgramRun} */
export const NO_RUN = { id: 0, state: 'NONE', program: '', output: '', exitCode: 0 };

/** @param {ProgramRun} run @returns {boolean} */
export function isUnderWay({ state }) {
  return state === 'STARTING' || state === 'RUNNING';
}

/**
 * @param {ProgramRun} run
 * @param {string} [example] name of the running example that will be copied to the program; empty for none
 * @returns {string} its state, as a sentence
 */
export function runText(run, example = '') {
  const name = fileName(run.program);
  switch (name === '' ? 'NONE' : run.state) {
    case 'STARTING':
      return `${name} is starting…`;
    case 'RUNNING':
      return example ? `${example} is running; saving makes your copy ${name}.` : `${name} is running.`;
    case 'STOPPED':
      return `${name} was stopped.`;
    case 'REFUSED':
      return `${name} has errors and was not started.`;
    case 'ENDED':
      return endText(name, run);
    default:
      return 'No program is running. Press Run.';
  }
}

/** @param {string} name @param {ProgramRun} run */
function endText(name, { output, exitCode }) {
  const endless = ENDLESS.exec(output);
  if (endless && exitCode !== 0) {
    return `${name} was stopped: think() did not return (${endless[1]}). Is there an infinite loop?`;
  }
  return exitCode === 0 ? `${name} has ended.` : `${name} has failed; see the error below.`;
}

/**
 * Finds the error that ended a program, which appears only in the program's output.
 *
 * @param {ProgramRun} run
 * @returns {import('./remarks.js').Mistake | undefined} undefined if the line that caused it is unknown
 */
export function crashOf({ state, program, output, exitCode }) {
  const at = state === 'ENDED' && exitCode !== 0 ? output.search(CRASH) : -1;
  if (at < 0) {
    return undefined;
  }
  const report = output.slice(at);
  const place = [...report.matchAll(PLACES)].find(([, file]) => file === fileName(program));
  return place && { line: Number(place[2]), text: report.split('\n')[0] };
}

/**
 * Removes from the output of a program the lines that its robot has also reported by telemetry, and those about joining the server.
 *
 * @param {string} output
 * @param {ReadonlySet<string>} reports messages of the warnings and errors in the robot's log
 * @returns {string}
 */
export function withoutReports(output, reports) {
  const lines = output.split('\n');
  return lines.filter((line) => !JOINING.test(line) && !reports.has(line.replace(REPORT_TIME, ''))).join('\n');
}

/**
 * Finds the robot of the program.
 *
 * @param {string} known key of the program's robot, if already known
 * @param {readonly string[]} before keys of the robots on the pitch before the first start
 * @param {readonly string[]} now keys of the robots on the pitch
 * @param {boolean} [entersFirst] whether the program started on an empty pitch
 * @returns {string} its key, empty if it has not joined yet
 */
export function ownRobot(known, before, now, entersFirst = false) {
  if (entersFirst && !now.includes(known)) {
    return now[0] ?? '';
  }
  return now.includes(known) ? known : (now.findLast((key) => !before.includes(key)) ?? now.at(-1) ?? '');
}
