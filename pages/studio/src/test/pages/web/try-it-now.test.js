/** The documentation of the published folder leads to the web edition, which is the front page. */
import assert from 'node:assert/strict';
import { quick } from '../tests.js';
import { openWebEdition } from '../user.js';

for (const to of ['docs/index.html', 'docs/tutorial/1-perception.html', 'docs/exercises/de/01-raise-arms.html']) {
  quick(`a robot is one click away from ${to}`, async (t) => {
    const { server, user } = await openWebEdition(t, { to });

    await user.clicks('link', 'Try it now');

    await user.sees(/cycle [1-9]\d{2}/);
    assert.equal(user.page.url().replace(/#.*/, ''), `${server.address}index.html`);
  });
}
