/** A team sends drawings for RoboViz, which appear in the 3D picture. */
import { createSocket } from 'node:dgram';
import { slow } from '../tests.js';
import { openStudio } from '../user.js';

const text = (words) => [...Buffer.from(words), 0];
const sixLetters = (...numbers) => [...Buffer.from(numbers.map((number) => number.toFixed(4)).join(''))];
const SWAP = [0, 0];
const RED = [255, 0, 0];

/** Sends a datagram of the team. */
async function send({ drawingPort }, ...bytes) {
  const socket = createSocket('udp4');
  await new Promise((done) => socket.send(Buffer.from(bytes), drawingPort, '127.0.0.1', done));
  socket.close();
}

/** Waits until the picture shows a number of corners of shapes, and texts. */
const shows = (user, corners, ...texts) =>
  user.until(async () => {
    const shown = await user.page.evaluate(() => {
      const { shapes, texts: labels } = studio.view.board;
      const count = shapes.visible ? shapes.geometry.attributes.position.count : 0;
      return [count, ...labels.children.filter(({ position }) => position.z > 0.6).map(({ name }) => name)];
    });
    return String(shown) === String([corners, ...texts]);
  });

slow('shapes and texts of teams are in the picture and in the list of sets', async (t) => {
  const { user, stage } = await openStudio(t, { robots: [{}] });
  await send(stage, 7, 7, 7, ...text('nonsense'));
  const circle = [1, 0, ...sixLetters(1, 2, 0.5, 2), ...RED, ...text('Stars.circle')];
  const words = [2, 1, 0, 255, 255, 255, ...text('I go to the ball')];
  await send(stage, ...circle, ...words, ...SWAP, ...text('Stars'));

  await shows(user, 240, 'I go to the ball');
  await user.clicks('button', 'Tools ▾');
  await user.clicks('DisclosureTriangle', 'Sets');
  await user.clicks('checkbox', 'Stars.circle');

  await shows(user, 0, 'I go to the ball');
});

slow('a swap without shapes erases', async (t) => {
  const { user, stage } = await openStudio(t, { robots: [{}] });
  await send(stage, 1, 3, ...sixLetters(1, 2, 0.5, 0.2), ...RED, ...text('a'), ...SWAP, ...text(''));
  await user.until(() => user.page.evaluate(() => studio.view.board.shapes.visible));

  await send(stage, ...SWAP, ...text('a'));

  await shows(user, 0);
});
