/** Navigation between the rooms (main views) of the studio; the fragment of the address identifies the room. */
import { byId, element } from './elements.js';

/** @typedef {'field' | 'program' | 'robot' | 'motion' | 'replay'} RoomName */

/** Rooms listed in the navigation; optional ones are hidden until they are offered. @type {Array<{room: RoomName, place: string, name: string, hint: string, part?: string, optional?: boolean}>} */
const ROOMS = [
  { room: 'field', place: 'field-room', name: 'Field', hint: 'Watch and steer the game' },
  { room: 'program', place: 'field-room', name: 'Program', hint: 'Write a program beside the robot', optional: true },
  { room: 'robot', place: 'field-room', name: 'Robot', hint: 'Inspect one robot' },
  { room: 'motion', place: 'motion-room', name: 'Motion', hint: 'Edit motions' },
  { room: 'replay', place: 'field-room', name: 'Replay', hint: 'Replay runs' },
  {
    room: 'field',
    place: 'field-room',
    name: 'Exercises',
    hint: 'Have your program graded',
    part: '/exercises',
    optional: true,
  },
];

/**
 * @param {(room: RoomName) => void} entered
 * @returns {() => RoomName} function that returns the current room
 */
export function roomsPanel(entered) {
  const links = ROOMS.map(({ room, name, hint, part = '', optional }) =>
    element('a', { href: `#${room}${part}`, title: hint, ...(optional && { hidden: '' }) }, name),
  );
  byId('rooms').append(...links);
  const current = () => ROOMS.find(({ room }) => location.hash.split('/')[0] === `#${room}`)?.room ?? 'field';
  const show = () => {
    const now = current();
    const { place: shown } = ROOMS.find(({ room }) => room === now) ?? ROOMS[0];
    byId('field-room').dataset.room = now;
    byId('replay').hidden = now !== 'replay';
    byId('workspace').hidden = shown === 'motion-room';
    ROOMS.forEach(({ room, place, part = '' }, i) => {
      const isHere = room === now && (now !== 'field' || location.hash.endsWith('/exercises') === (part !== ''));
      byId(place).hidden = place !== shown;
      links[i].toggleAttribute('aria-current', isHere);
      if (isHere) {
        links[i].setAttribute('aria-current', 'page');
      }
    });
    entered(now);
  };
  window.addEventListener('hashchange', show);
  queueMicrotask(show);
  return current;
}

/**
 * Shows the link to an optional room, or leaves the room.
 *
 * @param {string} place fragment of its address
 * @param {boolean} isThere whether this studio has the room
 */
export function offerRoom(place, isThere) {
  document.querySelector(`#rooms a[href='${place}']`)?.toggleAttribute('hidden', !isThere);
  if (!isThere && location.hash.startsWith(place)) {
    location.hash = '#field';
  }
}
