import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  initialWall,
  tileWords,
  wallSentence,
  withoutWallLine,
  withWallNews,
} from '../../main/resources/org/robonewbie/studio/web/state/wall.js';

const trial = (id, ...teams) => ({ id, teams, studio: `http://127.0.0.1:1/${id}`, length: 12, width: 8 });
const table = { over: 0, planned: 3, columns: ['Goal'], rows: [{ rank: 1, team: 'Red', cells: ['–'] }] };
const whole = (...trials) => ({ kind: 'whole', title: 'Scoring', rule: 'Score.', results: [], table, trials });
const moment = (id, seconds) => ({
  id,
  seconds,
  playMode: 'PlayOn',
  left: 'Red',
  right: 'Blue',
  score: [1, 0],
  ball: [0, 0],
  robots: [],
});

test('a trial keeps its tile, and its last picture stays until another trial needs the tile', () => {
  let wall = withWallNews(initialWall(), whole(trial('a', 'Red'), trial('b', 'Blue')));
  wall = withWallNews(wall, { kind: 'moments', moments: [moment('a', 3), moment('b', 4)] });

  wall = withWallNews(wall, whole(trial('b', 'Blue')));

  assert.deepEqual(
    wall.tiles.map(({ trial: { id }, running, moment: last }) => [id, running, last.seconds]),
    [
      ['a', false, 3],
      ['b', true, 4],
    ],
  );

  wall = withWallNews(wall, whole(trial('b', 'Blue'), trial('c', 'Green')));

  assert.deepEqual(
    wall.tiles.map(({ trial: { id }, running, moment: last }) => [id, running, last?.seconds]),
    [
      ['c', true, undefined],
      ['b', true, 4],
    ],
  );
});

test('a tile shows teams, score and time', () => {
  const running = { trial: trial('x', 'Red', 'Blue'), running: true, moment: moment('x', 65) };

  assert.deepEqual(tileWords(running), { teams: 'Red 1 : 0 Blue', time: '01:05', mode: 'Play on' });
  assert.equal(tileWords({ ...running, trial: trial('x', 'Red') }).teams, 'Red');
  assert.equal(tileWords({ ...running, running: false }).mode, 'Over');
  assert.deepEqual(tileWords({ ...running, moment: undefined }), {
    teams: 'Red – Blue',
    time: '',
    mode: 'The robots are joining …',
  });
});

test('a lost connection is reported, but not after the end', () => {
  const running = withWallNews(initialWall(), whole(trial('a', 'Red')));
  const over = withWallNews(running, { ...whole(), outcome: 'Table: table.html' });

  assert.match(wallSentence(withoutWallLine(running)).text, /is not responding/);
  assert.equal(withoutWallLine(running).tiles[0].running, false);
  assert.equal(wallSentence(withoutWallLine(over)).text, 'The competition is over. Table: table.html');
  assert.match(wallSentence(withWallNews(initialWall(), whole())).text, /next trials/);
});
