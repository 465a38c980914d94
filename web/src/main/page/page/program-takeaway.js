/** Two buttons in the bar of the room for programs: all programs as a zip, and a link that holds the one in the editor. */
import { button, byId } from '../panels/elements.js';
import { linkOf } from './share.js';
import { zip } from './zip.js';

const README = `Programs from RoboNewbie's page.

With RoboNewbie on your computer: robonewbie run MyAgent.java (with the name of your file) runs one of them, and
robonewbie new MyProject makes a project for an IDE; put the files into its folder src/main/java.
`;

/** @param {() => any} room @param {import('./program-shelf.js').ProgramShelf} shelf */
export function addTakeaways(room, shelf) {
  const place = byId('program-room');
  const watch = new MutationObserver(() => {
    const bar = place.querySelector('.program-bar');
    if (bar) {
      watch.disconnect();
      bar.append(
        button('Download', 'All programs of this browser as a zip', () => save(shelf), { id: 'program-zip' }),
        button('Link', 'Makes a link that holds this program', () => room().attempt(() => showLink(room())), {
          id: 'program-link',
        }),
      );
    }
  });
  watch.observe(place, { childList: true, subtree: true });
}

/** @param {import('./program-shelf.js').ProgramShelf} shelf */
function save(shelf) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(zip(new Map([['README.txt', README], ...shelf.texts])));
  link.download = 'robonewbie-programs.zip';
  link.click();
  URL.revokeObjectURL(link.href);
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
