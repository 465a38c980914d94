/** A newcomer opens the web edition for the first time. */
import assert from 'node:assert/strict';
import { slow } from '../tests.js';
import { openWebEdition } from '../user.js';

async function passes(user, title) {
  await user.sees(title);
  await user.sees('Type it, or press Tab:');
  while ((await user.text()).includes('Type it, or press Tab:')) {
    await user.presses('Tab');
  }
  await user.sees('Press ▶ Run (Ctrl+Enter).');
  await user.presses('Control+Enter');
  await user.sees('Well done: ');
  await user.presses('Enter');
}

async function comesAgainToTheField({ user, visit }) {
  await visit();
  await user.sees(/cycle \d{2}/);
  assert.equal(new URL(user.page.url()).hash, '');
}

slow('three levels lead to the first exercise and stay passed', async (t) => {
  const page = await openWebEdition(t, { isNewcomer: true });
  const { user } = page;

  await passes(user, 'Make the robot wave');
  await passes(user, 'Make it look at the ball');
  await passes(user, 'Make it walk to the ball and kick');

  await user.finds('button', 'Check');
  await user.sees('Waiting for a robot…');
  await user.fills('combobox', 'Program', 'own Wave.java');
  await user.sees('LEFT_SHOULDER_PITCH, 90');
  await comesAgainToTheField(page);
});

slow('skipped levels never return', async (t) => {
  const page = await openWebEdition(t, { isNewcomer: true });
  await page.user.sees('Make the robot wave');

  await page.user.clicks('button', 'Skip');

  await page.user.seesNo('Make the robot wave');
  await comesAgainToTheField(page);
});
