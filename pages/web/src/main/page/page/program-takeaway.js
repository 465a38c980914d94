/** Two buttons below the editor of the room for programs: all programs as a project in a zip, and a link that holds the one in the editor. */
import { button, byId, offer } from '../panels/elements.js';
import { project } from './project.js';
import { linkOf } from './share.js';
import { zip } from './zip.js';

/** @param {() => any} room @param {import('./program-repository.js').ProgramRepository} shelf */
export function addTakeaways(room, shelf) {
  const place = byId('program-room');
  const watch = new MutationObserver(() => {
    const foot = place.querySelector('.program-foot');
    if (foot) {
      watch.disconnect();
      foot.append(
        button(
          'Download',
          'All programs of this browser as a project for your computer, with all that it needs but Java (a zip of 16 MB)',
          () => room().attempt(() => save(room(), shelf)),
          { id: 'program-zip' },
        ),
        button('Link', 'Makes a link that holds this program', () => room().attempt(() => showLink(room())), {
          id: 'program-link',
        }),
      );
    }
  });
  watch.observe(place, { childList: true, subtree: true });
}

/** @param {any} room @param {import('./program-repository.js').ProgramRepository} shelf */
async function save(room, shelf) {
  const { file } = room.files;
  const programs = shelf.texts;
  if (file?.shelf === 'own') {
    programs.set(file.path, room.editor.text);
  }
  const { name, files } = await project(programs, file?.path ?? '');
  offer(`${name}.zip`, zip(files));
}

/** @param {any} room */
async function showLink(room) {
  const link = await linkOf(room.files.file.path, room.editor.text);
  history.replaceState(undefined, '', link);
  await navigator.clipboard?.writeText(link).catch(() => {});
  room.surroundings.note(
    'The link holds this program: it is in the address bar, and copied where the browser allows that.',
  );
}
