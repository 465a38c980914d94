/** Two buttons in the replay room: one downloads a recording as a file, and the other imports such files. */
import { button, byId, element, offer } from '../panels/elements.js';

/** @param {() => any} studio @param {import('./page-recordings.js').PageRecordings} recordings */
export function addRecordingTools(studio, recordings) {
  const note = (/** @type {unknown} */ failure) => studio().note(/** @type {Error} */ (failure).message);
  const choice = element('input', { type: 'file', accept: '.rec', multiple: '', hidden: '', id: 'recording-file' });
  choice.addEventListener('change', () =>
    importAll([...(choice.files ?? [])], recordings, studio().replay).catch(note),
  );
  const open = button('Open a file…', 'Opens recordings made by RoboNewbie on a computer', () => choice.click(), {
    id: 'recording-open',
  });
  const save = button(
    'File',
    'Save the recording, to view it on your computer with: ./robonewbie studio FILE.rec',
    () => saveFile(studio().replay.file?.name, recordings).catch(note),
    { id: 'export-recording' },
  );
  whenThere(byId('recordings'), '.list-tools', (tools) => tools.prepend(choice, open));
  whenThere(byId('replay'), '.replay-export', (tools) => tools.prepend(save));
}

/** @param {HTMLElement} place @param {string} selector @param {(found: Element) => void} act */
function whenThere(place, selector, act) {
  const watch = new MutationObserver(() => {
    const found = place.querySelector(selector);
    if (found) {
      watch.disconnect();
      act(found);
    }
  });
  watch.observe(place, { childList: true, subtree: true });
}

/** @param {File[]} files @param {import('./page-recordings.js').PageRecordings} recordings @param {{refresh: () => Promise<void>}} room */
async function importAll(files, recordings, room) {
  let last = '';
  for (const file of files) {
    last = await recordings.take(file.name, new Uint8Array(await file.arrayBuffer()));
  }
  await room.refresh();
  location.hash = `#replay/${encodeURIComponent(last)}`;
}

/** @param {string | undefined} name @param {import('./page-recordings.js').PageRecordings} recordings */
async function saveFile(name, recordings) {
  if (name === undefined) {
    throw new Error('Choose a recording first.');
  }
  offer(`${name}.rec`, await recordings.file(name));
}
