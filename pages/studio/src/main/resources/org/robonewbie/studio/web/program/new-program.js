/** Creates programs: a minimal one, or a copy of an example. Never replaces an existing program, whether or not it has been saved. */
import { ask } from '../panels/questions.js';
import { encodeText, UTF_8 } from '../state/decoded-text.js';
import { classNameProblem, FIRST_NAME, folderOfNew, freeName, javaName } from '../state/program/documents.js';
import { fileName } from '../state/program/remarks.js';

/** @typedef {import('./file-controller.js').FileController} FileController */

/** Asks for a name and creates the program. @param {FileController} files @param {string} example template, or empty */
export async function makeProgram(files, example) {
  const folder = folderOfNew(files.list.own);
  const name = await ask({
    title: example ? 'Make my own copy' : 'New program',
    label: 'Name',
    value: nameFor(files, example)
      .slice(folder.length)
      .replace(/\.java$/, ''),
    action: 'Create',
    problem: classNameProblem,
    hint: 'A class name: letters and digits, starting with a capital letter.',
  });
  if (name) {
    await create(files, folder + javaName(name), example);
  }
}

/** Creates an editable copy of the open example. @param {FileController} files */
export async function copyExample(files) {
  if (files.file?.kind === 'example') {
    await create(files, nameFor(files, files.file.path), files.file.path);
  }
}

/** @param {FileController} files @param {string} example @returns {string} a free path for a copy of it */
function nameFor({ list, file }, example) {
  const wanted = example ? `My${example.replace(/^Agent_/, '')}.java` : FIRST_NAME;
  return freeName(folderOfNew(list.own) + wanted, [...list.own, ...list.drafts, ...(file ? [file] : [])]);
}

/** @param {FileController} files @param {string} path @param {string} example */
async function create(files, path, example) {
  if (!(await files.drafts.keep())) {
    return;
  }
  await files.refresh();
  if (files.list.drafts.some((each) => each.path === path)) {
    throw new Error(`There is already an unsaved program named ${fileName(path)}. Choose another name.`);
  }
  await files.service.write(path, encodeText(UTF_8, await files.service.newProgram(path, example)), '');
  await files.refresh();
  await files.openOwn(path);
}
