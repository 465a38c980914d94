/**
 * Two buttons below the editor: one downloads all programs as a zipped project, and the other shows a link that contains the open program.
 */
import { button, byId, offer } from '../panels/elements.js';
import { project } from './project.js';
import { linkOf } from './share.js';
import { zip } from './zip.js';

/** @param {() => any} room @param {import('./program-repository.js').ProgramRepository} repository */
export function addExportButtons(room, repository) {
  const place = byId('program-room');
  const watch = new MutationObserver(() => {
    const foot = place.querySelector('.program-foot');
    if (foot) {
      watch.disconnect();
      foot.append(
        button(
          'Download',
          'Downloads all programs in this browser as a project for your computer, with everything it needs except Java (a 16 MB zip file)',
          () => room().attempt(() => save(room(), repository)),
          { id: 'program-zip' },
        ),
        button('Link', 'Creates a link that contains this program', () => room().attempt(() => showLink(room())), {
          id: 'program-link',
        }),
      );
    }
  });
  watch.observe(place, { childList: true, subtree: true });
}

/** @param {any} room @param {import('./program-repository.js').ProgramRepository} repository */
async function save(room, repository) {
  const { file } = room.files;
  const programs = repository.texts;
  if (file?.repository === 'own') {
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
    'The link contains this program. It is in the address bar and, if the browser allows it, also on the clipboard.',
  );
}
