/** Motions in the web edition: the browser stores them, and a robot with weight plays them. */
import { quick } from '../tests.js';
import { openWebEdition } from '../user.js';

/** Two keyframes of a standing robot; the second one turns its neck. */
const turnNeckTo = (degrees) => `500 0 0 -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25
1000 0 ${degrees} -90 10 0 -25 0 0 25 -50 25 0 0 0 25 -50 25 0 -90 -10 0 25
`;
const PLAYER = `import org.robonewbie.agent.Agent;
import org.robonewbie.nao.Joint;

public class MyAgent extends Agent {
    @Override
    protected void think() {
        motions.start("mine");
        log.info("neck %.1f", nao.getJointAngle(Joint.NECK_PITCH));
    }
}
`;

quick('a robot with weight plays a motion of the library without falling', async (t) => {
  const { user } = await openWebEdition(t, { to: '#motion/wave' });

  await user.clicks('button', 'Try with physics');

  await user.sees('The robot stays on its feet.');
});

quick('an own motion and its unsaved changes are there again after a visit', async (t) => {
  const { user, visit } = await openWebEdition(t);
  await user.stores('motion', 'mine', turnNeckTo(12.5));
  await visit('#motion/mine');
  await user.readsValue('textbox', 'neck pitch in degrees', '0');

  await user.fills('textbox', 'neck pitch in degrees', '7.5');
  await user.presses('Enter');
  await user.until(() =>
    user.page.evaluate(() => Object.keys(localStorage).some((key) => key.endsWith('page-motion-draft:mine'))),
  );
  await visit('#motion/mine');

  await user.readsValue('textbox', 'neck pitch in degrees', '7.5');
});

quick('a motion of a T1 is shown with its joints', async (t) => {
  const { user, visit } = await openWebEdition(t);
  await user.stores('motion', 'mine', `// robot: T1\n500 12.5${' 0'.repeat(22)}\n`);

  await visit('#motion/mine');

  await user.readsValue('textbox', 'head yaw in degrees', '12.5');
});

quick('a program starts a motion that was made in the page, and then its new version', async (t) => {
  const { user } = await openWebEdition(t, { to: '#program' });
  await user.stores('motion', 'mine', turnNeckTo(12.5));

  await user.writes(PLAYER);
  await user.clicks('button', '▶ Run');

  await user.reads('list', 'Log of the robot', 'neck 12.5');
  await user.stores('motion', 'mine', turnNeckTo(-9.5));
  await user.reads('list', 'Log of the robot', 'neck -9.5');
});
