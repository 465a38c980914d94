/** The documentation of the published folder leads to the web edition, which is its front page. */
import assert from 'node:assert/strict';
import { quick } from '../tests.js';
import { openWebEdition } from '../user.js';

quick('a robot is one click away from each page of the documentation', async (t) => {
  const { server, user, visit } = await openWebEdition(t, { to: 'docs/exercises/de/01-raise-arms.html' });

  for (const page of ['docs/exercises/de/01-raise-arms.html', 'docs/tutorial/1-perception.html', 'docs/index.html']) {
    await visit(page);
    const link = await user.finds('link', 'Try it now');
    assert.equal(await link.evaluate(({ href }) => href), `${server.address}index.html`);
  }
  await Promise.all([user.page.waitForNavigation(), user.clicks('link', 'Try it now')]);

  await user.sees(/cycle [5-9]\d|cycle \d{3}/);
});
