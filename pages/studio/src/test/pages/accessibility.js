/** Checks a page with axe-core, which knows the rules of accessibility. */
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const AXE = fileURLToPath(import.meta.resolve('axe-core/axe.min.js'));

/** Waits until no rule is violated; the page hides and shows things twice a second. The message of a failure says where it happened. */
export async function findsNoBarrier(user, place) {
  await user.page.evaluate(`${readFileSync(AXE, 'utf8')}; true`);
  let barriers = [];
  await user.until(
    async () => (barriers = await user.page.evaluate(violations)).length === 0,
    () => `finds no barrier in ${place}, but\n${barriers.join('\n')}\n`,
  );
}

/** Returns rules and elements; one line for each element. */
async function violations() {
  const found = await window.axe.run(document, { resultTypes: ['violations'] });
  return found.violations.flatMap(({ help, nodes }) =>
    nodes.map(({ target, html }) => `${help}: ${target.join(' ')} ${html.slice(0, 200)}`),
  );
}
