/** axe-core finds no violation of the rules of accessibility in any room or dialog, in the light and the dark theme. */
import { findsNoBarrier } from '../accessibility.js';
import { folderWith, openStage } from '../stage.js';
import { slow } from '../tests.js';
import { newUser, openStudio } from '../user.js';

const KEYFRAMES = `200${' 0'.repeat(22)}\n400${' 0'.repeat(22)}\n`;
const KICK = '12 A kick of your own challenge · 120 min';

const ROOMS = {
  field: (user) => user.finds('button', '❚❚ Pause'),
  'field/exercises': (user) => user.finds('button', KICK),
  program: (user) => user.finds('button', 'Save'),
  robot: (user) => user.page.waitForSelector('.joint-row'), // a phone shows a notice instead
  'motion/mine': (user) => user.page.waitForSelector('[data-keyframe]'),
  replay: (user) => user.finds('region', 'Recordings'),
  'replay/game': (user) => user.clicks('button', '▶ Play'),
};

/** Unfolds all that folds. */
const unfolds = (user) => user.page.$$eval('details', (all) => all.forEach((each) => (each.open = true)));

/** Dialogs and what appears by use: the room, and what the user does there. */
const DIALOGS = {
  'the field with all that folds': ['field', unfolds],
  'the list of keys': [
    'field',
    async (user) => {
      await user.clicks('button', 'Keys');
      await user.finds('dialog', 'Keys and mouse');
    },
  ],
  'an exercise': [
    'field/exercises',
    async (user) => {
      await user.clicks('button', KICK);
      await user.finds('combobox', 'Program to run');
      await unfolds(user);
    },
  ],
  'the messages of a robot': [
    'robot',
    async (user) => {
      await user.clicks('button', 'Messages');
      await unfolds(user);
    },
  ],
  'a mistake in a program': [
    'program',
    async (user) => {
      await user.writes('public class MyAgent {\n    int angle = degres;\n}\n');
      await user.sees('cannot find symbol');
    },
  ],
  'an exercise in the Program room': [
    'program',
    async (user) => {
      await user.fills('combobox', 'Program', 'exercise kick');
      await user.finds('link', 'Worksheet');
    },
  ],
  'the history of a program': [
    'program',
    async (user) => {
      await user.writes('public class MyAgent {}\n');
      await user.clicks('button', 'Save');
      await user.writes('class MyAgent {}\n');
      await user.clicks('button', 'History');
      await user.finds('listbox', 'Saved versions');
    },
  ],
  'the curves and the menu of a motion': [
    'motion/mine',
    async (user) => {
      await user.clicks('button', 'Curves');
      await user.clicks('button', 'Motion ▾');
    },
  ],
  'the question for the name of a motion': [
    'motion/mine',
    async (user) => {
      await user.clicks('button', 'Save as…');
      await user.finds('textbox', 'Name');
    },
  ],
  'the bookmarks of a recording': [
    'replay/game',
    async (user) => {
      await unfolds(user);
      await user.fills('textbox', 'Note for this moment', 'here');
      await user.clicks('button', 'Add');
      await user.page.waitForSelector('.bookmark-go', { visible: true });
    },
  ],
  'the comparison of two recordings': [
    'replay/game',
    async (user) => {
      await user.fills('combobox', 'Compare with', 'other');
      await user.page.waitForSelector('#compare-reading:not(:empty)');
    },
  ],
  'the new name of a recording': ['replay', (user) => user.clicks('button', 'Rename game')],
  'a deleted recording': [
    'replay',
    async (user) => {
      await user.clicks('button', 'Delete game');
      await user.findsNo('button', 'Delete game');
    },
  ],
};

const TASK = {
  subject: 'kick',
  objective: 'kick-distance',
  unit: 'm',
  isLargerBetter: true,
  rounds: 3,
  method: '3 rounds',
};

const openWhole = (t, options) =>
  openStudio(t, { robots: [{}], files: { 'mine.txt': KEYFRAMES }, recordings: ['game', 'other'], ...options });

async function findsNoBarrierInAnyRoom(t, options) {
  const { user, visit } = await openWhole(t, options);
  for (const [room, isThere] of Object.entries(ROOMS)) {
    await visit(room);
    await isThere(user);
    await findsNoBarrier(user, `#${room}`);
  }
}

/** Opens the page of an optimisation that has not begun. */
async function openSearch(t, { theme = 'light', ...look } = {}) {
  const stage = await openStage(t, await folderWith(t), { search: TASK });
  const user = await newUser(t, look);
  await user.visits(`${(await stage.address()).replace('/?', '/optimise.html?')}&theme=${theme}`);
  await user.sees('kick');
  return user;
}

for (const theme of ['light', 'dark']) {
  slow(`no room has a barrier in the ${theme} theme`, (t) => findsNoBarrierInAnyRoom(t, { theme }));

  slow(`no dialog has a barrier in the ${theme} theme`, async (t) => {
    const { user, visit } = await openWhole(t, { theme });
    for (const [place, [room, acts]] of Object.entries(DIALOGS)) {
      await visit(room);
      await ROOMS[room](user);
      await acts(user);
      await findsNoBarrier(user, place);
    }
  });

  slow(`the page of an optimisation has no barrier in the ${theme} theme`, async (t) => {
    const user = await openSearch(t, { theme });

    await findsNoBarrier(user, 'the page of an optimisation');
  });
}

for (const [width, height] of [
  [1024, 768],
  [820, 1180],
  [390, 844],
]) {
  slow(`no room has a barrier on a screen of ${width} by ${height} pixels`, (t) =>
    findsNoBarrierInAnyRoom(t, { width, height }),
  );
}
