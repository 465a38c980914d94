import assert from 'node:assert/strict';
import test from 'node:test';
import { playModeText } from '../../main/resources/org/robonewbie/studio/web/state/play-mode.js';

const teams = { left: 'Blue', right: '' };

test('play modes of a team name the team', () => {
  assert.equal(playModeText('corner_kick_left', teams), 'Corner kick · Blue');
  assert.equal(playModeText('Goal_Left', teams), 'Goal · Blue');
});

test('a team without a name is named by its side', () => {
  assert.equal(playModeText('KickOff_Right', teams), 'Kick-off · right');
});

test('other play modes have display names', () => {
  assert.equal(playModeText('BeforeKickOff', teams), 'Before kick-off');
  assert.equal(playModeText('PlayOn', teams), 'Play on');
});

test('an unknown play mode is shown unchanged', () => {
  assert.equal(playModeText('Penalty_Shootout', teams), 'Penalty_Shootout');
});
