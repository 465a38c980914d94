import assert from 'node:assert/strict';
import test from 'node:test';
import {
  clock,
  initialState,
  message,
  nearestSpeed,
  neighbourSpeed,
  scoreBoard,
  transport,
  withConnection,
  withFrame,
  withoutConnection,
  withRefusal,
  withScene,
  withStarting,
} from '../../main/resources/org/robonewbie/studio/web/state/studio-state.js';
import { sampleFrame, sampleScene } from './sample-world.js';

const live = () => withScene(withConnection(initialState()), sampleScene());

test('a new page looks for the simulator', () => {
  assert.match(message(initialState(), 0)?.title ?? '', /Looking for the simulator/);
});

test('a lost connection is reported as temporary', () => {
  const lost = withoutConnection(live());

  assert.match(message(lost, 0)?.title ?? '', /has ended/);
  assert.match(message(lost, 0)?.text ?? '', /reconnects automatically/);
});

test('a page that was never connected keeps looking', () => {
  assert.match(message(withoutConnection(initialState()), 0)?.title ?? '', /Looking/);
});

test('a refused page shows the reason until it is accepted', () => {
  const refused = withRefusal(withoutConnection(live()), 'This browser is not signed in.');

  assert.equal(message(refused, 0)?.text, 'This browser is not signed in.');
  assert.notEqual(message(withConnection(refused), 0)?.text, 'This browser is not signed in.');
});

test('an empty field waits for a robot', () => {
  const empty = withScene(live(), { ...sampleScene(), robots: [] });

  assert.match(message(empty, 0)?.title ?? '', /Waiting for a robot/);
  assert.match(message(empty, 0)?.text ?? '', /run Agent_BasicStructure/);
  assert.match(message(empty, 0, true)?.text ?? '', /Edit beside the robot/);
});

test('a world without a port suggests only what is possible there', () => {
  const closed = withScene(live(), { ...sampleScene(), robots: [], agentPort: 0 });

  assert.match(message(closed, 0)?.text ?? '', /Choose an agent in the toolbar/);
});

test('a standing world announces what is about to replace it', () => {
  const standing = withFrame(live(), sampleFrame(), 1000);
  const starting = withStarting(standing, 'Starting trial 1…');

  assert.equal(message(starting, 9000)?.title, 'Starting trial 1…');
  assert.equal(starting.frame, standing.frame);
  assert.equal(message(withScene(starting, sampleScene()), 9000), undefined);
});

test('a moving world needs no message', () => {
  assert.equal(message(withFrame(live(), sampleFrame(), 1000), 1500), undefined);
});

test('a world that stands still without pause waits for an agent', () => {
  const first = withFrame(live(), sampleFrame(), 1000);
  const same = withFrame(first, sampleFrame(), 3000);

  assert.match(message(same, 3100)?.title ?? '', /is waiting for an agent/);
});

test('a paused world needs no message', () => {
  const first = withFrame(live(), sampleFrame({ paused: true }), 1000);
  const same = withFrame(first, sampleFrame({ paused: true }), 3000);

  assert.equal(message(same, 3100), undefined);
  assert.equal(message(same, 60_000), undefined);
  assert.equal(message(withFrame(same, sampleFrame(), 60_000), 60_500), undefined);
});

test('states are replaced and never changed', () => {
  const before = live();
  const copy = structuredClone(before);

  withFrame(before, sampleFrame(), 1);
  withoutConnection(before);

  assert.deepEqual(before, copy);
});

test('the scoreboard shows teams, score, time and play mode', () => {
  const board = scoreBoard(withFrame(live(), sampleFrame({ gameTime: 75, half: 2, playMode: 1 }), 0), 0);

  assert.equal(board.left, 'Blue');
  assert.equal(board.right, 'no team yet');
  assert.equal(board.hasRight, false);
  assert.equal(board.score, '1 : 0');
  assert.equal(board.clock, '01:15');
  assert.equal(board.half, '2nd half');
  assert.equal(board.playMode, 'Kick-off · Blue');
});

test('the scoreboard is for two teams, or for goals', () => {
  const alone = withFrame(live(), sampleFrame({ scoreLeft: 0 }), 0);
  const both = { ...sampleScene(), teams: { left: 'Blue', right: 'Red' } };

  assert.equal(scoreBoard(live(), 0).isGame, false);
  assert.equal(scoreBoard(alone, 0).isGame, false);
  assert.equal(scoreBoard(withFrame(live(), sampleFrame({ scoreLeft: 1 }), 0), 0).isGame, true);
  assert.equal(scoreBoard(withScene(live(), both), 0).isGame, true);
});

test('a goal is celebrated for some seconds', () => {
  const before = withFrame(live(), sampleFrame({ scoreRight: 0 }), 1000);
  const goal = withFrame(before, sampleFrame({ scoreRight: 1 }), 2000);

  assert.equal(scoreBoard(before, 1000).cheers, '');
  assert.equal(scoreBoard(goal, 3000).cheers, 'right');
  assert.equal(scoreBoard(goal, 9000).cheers, '');
});

test('the scoreboard is readable before anything is known', () => {
  assert.equal(scoreBoard(initialState(), 0).score, '– : –');
});

test('time controls work only with a world', () => {
  assert.equal(transport(live()).enabled, false);
  assert.equal(transport(withFrame(live(), sampleFrame(), 0)).enabled, true);
});

test('time controls show seconds, cycle and real-time factor', () => {
  const shown = transport(withFrame(live(), sampleFrame({ cycle: 151, realTimeFactor: 12.3 }), 0));

  assert.equal(shown.seconds, '3.02 s');
  assert.equal(shown.cycle, 'cycle 151');
  assert.equal(shown.realTimeFactor, '12× real time');
});

test('a clock has minutes and seconds', () => {
  assert.equal(clock(0), '00:00');
  assert.equal(clock(59.99), '00:59');
  assert.equal(clock(600), '10:00');
});

test('requested speeds are shown as the nearest of the list', () => {
  assert.equal(nearestSpeed(0.3), 0.25);
  assert.equal(nearestSpeed(1), 1);
  assert.equal(nearestSpeed(12), 10);
  assert.equal(nearestSpeed(Infinity), 'fastest');
});

test('faster and slower walk through the list and stop at its ends', () => {
  assert.equal(neighbourSpeed(1, 1), 2);
  assert.equal(neighbourSpeed(1, -1), 0.5);
  assert.equal(neighbourSpeed(10, 1), 'fastest');
  assert.equal(neighbourSpeed(Infinity, 1), 'fastest');
  assert.equal(neighbourSpeed(0.1, -1), 0.1);
});

test('a side without a team has a placeholder', () => {
  const { left, right } = scoreBoard(initialState(), 0);

  assert.deepEqual([left, right], ['no team yet', 'no team yet']);
});
