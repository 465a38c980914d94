/** A robot of a foreign program. */
import { connect } from 'node:net';
import { atEnd } from './tests.js';

/**
 * Lets a robot join at a port, until the test ends.
 *
 * @param {import('node:test').TestContext} t
 * @param {number} port
 * @param {{ team: string, number?: number, act?: (cycle: number) => string }} robot `act` returns what it sends in a cycle
 */
export function join(t, port, { team, number = 1, act = () => '' }) {
  const socket = connect(port, '127.0.0.1');
  let cycle = 0;
  const say = (text) => {
    const message = Buffer.alloc(4 + text.length);
    message.writeUInt32BE(text.length);
    message.write(text, 4);
    socket.write(message);
  };
  atEnd(t, () => socket.destroy());
  socket.on('error', () => socket.destroy());
  say('(scene rsg/agent/nao/nao.rsg)(syn)');
  socket.once('data', () => say(`(init (unum ${number})(teamname ${team}))(syn)`));
  socket.on('data', () => say(`${act(cycle++)}(syn)`));
}
