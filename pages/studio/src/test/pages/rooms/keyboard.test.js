/** By the keyboard alone, in each room and on a small projector. */
import assert from 'node:assert/strict';
import { folderWith, openStage } from '../stage.js';
import { slow } from '../tests.js';
import { newUser, openStudio } from '../user.js';

const KICK = '12 A kick of your own challenge · 120 min';
const KEYFRAMES = `200${' 0'.repeat(22)}\n400${' 0'.repeat(22)}\n`;

const TASK = {
  subject: 'kick',
  objective: 'kick-distance',
  unit: 'm',
  isLargerBetter: true,
  rounds: 3,
  method: '3 rounds',
};

/** Rooms, and what a user does and sees there before the walk. */
const PLACES = {
  'the field': ['field', (user) => user.finds('button', '▶ Play')],
  'an exercise': [
    'field/exercises',
    async (user) => {
      await user.clicks('button', KICK);
      await user.finds('combobox', 'Program to run');
    },
  ],
  'the Robot room': ['robot', (user) => user.sees('Shoulder pitch')],
  'the Motion room': ['motion/mine', (user) => user.finds('button', 'mine')],
  'a replay': ['replay/game', (user) => user.clicks('button', '▶ Play')],
};

const openPaused = (t, room) =>
  openStudio(t, {
    room,
    files: { 'mine.txt': KEYFRAMES },
    robots: [{}],
    recordings: ['game'],
    isPaused: true,
    width: 1024,
  });

/** Notes which controls get the focus, and which of those show no ring. */
function watchTheFocus() {
  const controls =
    'button, a[href], input, select, textarea, summary, [role=button], [role=slider], [role=tab], [tabindex="0"]';
  const isUsable = (each) =>
    !each.disabled && each.checkVisibility({ visibilityProperty: true }) && each.getClientRects().length > 0;
  const groupOf = (each) => (each.type === 'radio' ? each.name : each);
  const nameOf = (each) => `${each.tagName} ${each.id} ${each.ariaLabel ?? ''} ${each.textContent.trim().slice(0, 30)}`;
  const all = () => [...document.querySelectorAll(controls)];
  const reached = new Set();
  const plain = new Set();
  document.addEventListener('focusin', ({ target }) => {
    const ring = getComputedStyle(target);
    reached.add(groupOf(target));
    if (ring.outlineStyle === 'none' || parseFloat(ring.outlineWidth) < 2) {
      plain.add(nameOf(target));
    }
  });
  window.walk = {
    count: () => all().length,
    missed: () => all().filter((each) => isUsable(each) && !reached.has(groupOf(each))),
    seen: () => ({
      missed: window.walk.missed().map(nameOf),
      beside: all()
        .filter((each) => isUsable(each) && each.getBoundingClientRect().right > innerWidth + 1)
        .map(nameOf),
      plain: [...plain],
    }),
  };
}

/** Presses Tab until every control has had the focus, at most twice as often as there are controls. */
async function walksThrough(user) {
  await user.page.evaluate(watchTheFocus);
  const most = 30 + 2 * (await user.page.evaluate(() => window.walk.count()));
  for (let i = 0; i < most && (await user.page.evaluate(() => window.walk.missed().length > 0)); i++) {
    await user.presses('Tab');
  }
  assert.deepEqual(await user.page.evaluate(() => window.walk.seen()), { missed: [], beside: [], plain: [] });
}

for (const [place, [room, comes]] of Object.entries(PLACES)) {
  slow(`Tab reaches each control of ${place}, which shows its focus and is on the page`, async (t) => {
    const { user } = await openPaused(t, room);
    await comes(user);

    await walksThrough(user);
  });
}

slow('Tab reaches each control of the page of an optimisation, which shows its focus and is on the page', async (t) => {
  const stage = await openStage(t, await folderWith(t), { search: TASK });
  const user = await newUser(t, { width: 1024 });
  await user.visits((await stage.address()).replace('/?', '/optimise.html?'));
  await user.sees('kick');

  await walksThrough(user);
});

slow('the arrow keys on the timeline of a motion choose the keyframe', async (t) => {
  const { user } = await openPaused(t, 'motion/mine');
  const timeline = await user.finds('region', 'Timeline. The left and right arrow keys select a keyframe.');
  await timeline.focus();

  await user.presses('ArrowRight');
  await user.page.waitForSelector('.keyframe.chosen[aria-label="Keyframe 2 at 0.60 s"]');
  await user.presses('ArrowLeft');

  await user.page.waitForSelector('.keyframe.chosen[aria-label="Keyframe 1 at 0.20 s"]');
  assert.ok(await timeline.evaluate((node) => node === document.activeElement));
});

slow('the list of keys opens with the focus on its button', async (t) => {
  const { user } = await openPaused(t, 'field');

  await user.clicks('button', 'Keys');

  await user.finds('dialog', 'Keys and mouse');
  await user.until(() => user.page.evaluate(() => document.activeElement.textContent === 'Close'));
});
