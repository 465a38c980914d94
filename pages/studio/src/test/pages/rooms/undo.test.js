/** All changes of the world can be undone exactly. */
import { isDeepStrictEqual } from 'node:util';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

/**
 * Opens the Field room with a puppet in a world that stands still. The page is so high that the tools need no scrolling: for a moment after
 * it, a coarse page takes a click near the lower edge of the panel for one on the panel itself.
 */
async function openField(t) {
  const studio = await openStudio(t, { speed: 2 });
  const { user } = studio;
  await user.clicks('button', 'Tools ▾');
  await user.clicks('button', 'Add a puppet');
  await user.sees('You are steering Puppets 1');
  await seesWorld(studio, ({ robots }) => robots[0].place.x > -1);
  await seesNext(user, 'puppet added');
  await user.clicks('button', '❚❚ Pause');
  await user.finds('button', '▶ Play');
  return studio;
}

/** Waits until the button Undo says what it undoes. */
async function seesNext(user, change) {
  const undo = await user.finds('button', 'Undo');
  let title = '';
  await user.until(
    async () => (title = await undo.evaluate((button) => button.title)) === `Undo: ${change} (Ctrl+Z)`,
    () => `sees ${change} on Undo, which says ${title}`,
  );
}

async function dragsTheBall(user, x, y) {
  await user.presses('3');
  await user.drags(await user.pointOf(0, 0, 0.04), await user.pointOf(x, y, 0.04));
  await seesNext(user, 'ball moved');
}

/** Waits until the world is as a condition says. */
const seesWorld = ({ user, stage }, condition) => user.until(async () => condition(await stage.world()));

const isNear = (value, wanted) => Math.abs(value - wanted) < 0.1;

slow('a drag of the ball is one step that is undone exactly', async (t) => {
  const studio = await openField(t);
  const { user, stage } = studio;
  const before = (await stage.world()).ball;
  await dragsTheBall(user, 4, 1);
  await seesWorld(studio, ({ ball }) => isNear(ball.x, 4));

  await user.presses('Control+z');

  await user.sees('Undone: ball moved.');
  await seesWorld(studio, ({ ball }) => isDeepStrictEqual(ball, before));
  await seesNext(user, 'puppet added');
  await user.presses('Control+Shift+Z');
  await user.sees('Redone: ball moved.');
  await seesWorld(studio, ({ ball }) => isNear(ball.x, 4));
});

slow('a turned robot, the play mode and a reset are undone one by one', async (t) => {
  const studio = await openField(t);
  const { user, stage } = studio;
  const isTurned = ({ heading, place }) => Math.abs(heading - 90) < 8 && isNear(place.x, before.place.x);
  const [before] = (await stage.world()).robots;
  await user.presses('3');
  const { x, y } = before.place;
  await user.drags(await user.pointOf(x, y, 0.35), await user.pointOf(x, y + 2, 0), 'Control');
  await seesNext(user, 'robot turned');
  await seesWorld(studio, ({ robots }) => isTurned(robots[0]));
  await user.fills('combobox', 'Play mode', 'KickOff_Right');
  await seesWorld(studio, ({ playMode }) => playMode === 'KICK_OFF_RIGHT');
  await user.clicks('button', 'Reset');
  await seesNext(user, 'reset');

  await user.clicks('button', 'Undo');
  await user.sees('Undone: reset.');
  await seesWorld(studio, ({ playMode, robots }) => playMode === 'KICK_OFF_RIGHT' && isTurned(robots[0]));
  await user.clicks('button', 'Undo');
  await user.sees('Undone: play mode changed.');
  await seesWorld(studio, ({ playMode }) => playMode !== 'KICK_OFF_RIGHT');
  await user.clicks('button', 'Undo');
  await user.sees('Undone: robot turned.');
  await seesWorld(studio, ({ robots }) => isDeepStrictEqual(robots[0], before));
});

slow('a running clock keeps running after Undo', async (t) => {
  const studio = await openField(t);
  const { user } = studio;
  await user.clicks('button', '▶ Play');
  await dragsTheBall(user, 3, 2);

  await user.presses('Control+z');

  await user.sees('Undone: ball moved.');
  await seesWorld(studio, ({ ball, isPaused }) => ball.x < 1 && !isPaused);
});

slow('a removed puppet returns to its position', async (t) => {
  const studio = await openField(t);
  const { user } = studio;
  const hasRobots = (count) => seesWorld(studio, ({ robots }) => robots.length === count);
  const isInPlace = () => seesWorld(studio, ({ robots }) => robots[1].place.x > -1.5);
  await user.clicks('button', '▶ Play');
  await user.clicks('button', 'Add a puppet');
  await user.sees('You are steering Puppets 2');
  await isInPlace();

  await user.clicks('button', 'Remove');
  await hasRobots(1);
  await seesNext(user, 'puppet removed');
  await user.clicks('button', 'Undo');

  await hasRobots(2);
  await isInPlace();
  await user.clicks('button', 'Redo');
  await hasRobots(1);
});

slow('in a text field Ctrl+Z undoes the text, in a list the last change of the world', async (t) => {
  const { user } = await openField(t);
  await dragsTheBall(user, 3, 2);

  await user.clicks('textbox', 'Name of the scene');
  await user.types('Kick');
  await user.presses('Control+z');
  await user.readsValue('textbox', 'Name of the scene', '');
  await seesNext(user, 'ball moved');
  await (await user.finds('combobox', 'Play mode')).focus();
  await user.presses('Control+z');

  await user.sees('Undone: ball moved.');
});
