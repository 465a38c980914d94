/** Imports and exports motions in the formats of other programs. */
import { offer } from '../panels/elements.js';
import { documentOf } from '../state/motion/editor-state.js';
import { ENDINGS, formatsFor, MAX_BYTES, readMotion } from '../state/motion/interchange.js';
import { stanceOf } from '../state/motion/poses.js';
import { askChoice, askFile } from '../panels/questions.js';

/** @typedef {import('./editor.js').Editor} Editor */

/** @param {Editor} editor */
export async function importFile(editor) {
  const file = await askFile(ENDINGS);
  if (file) {
    if (file.size > MAX_BYTES) {
      throw new Error(`${file.name} was not imported: it is larger than 2 MB, the limit for motions.`);
    }
    const body = await editor.files.body();
    const bytes = new Uint8Array(await file.arrayBuffer());
    const { document, notes } = readMotion(file.name, bytes, body, stanceOf(body));
    await editor.take(document, file.name, notes);
  }
}

/** @param {Editor} editor */
export async function exportFile(editor) {
  const formats = formatsFor(editor.state.body);
  const id = await askChoice({
    title: 'Export the motion',
    label: 'For',
    action: 'Export',
    hint: 'The file is saved to your browser’s downloads. Import… can read all of these formats.',
    entries: formats.map((format) => [format.id, format.name]),
  });
  const format = formats.find((each) => each.id === id);
  if (format) {
    const { body, start, name, draft } = editor.state;
    offer(`${name || draft || 'motion'}${format.ending}`, format.write(documentOf(editor.state), body, start));
  }
}
