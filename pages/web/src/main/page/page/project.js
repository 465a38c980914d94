/** All programs of this browser as a project such as `robonewbie new` makes: to be built and run without this page. */

/**
 * @typedef {object} Template what `robonewbie new` has made while this page was built
 * @property {string} name
 * @property {string} package
 * @property {Record<string, string>} texts by path
 * @property {string[]} libraries paths of files that are no texts
 */

const FOLDER = 'project/';
const JAVA = 'src/main/java/';
const USUAL = 'MyAgent';

/** @param {string} path @returns {string} */
const fileName = (path) => path.split('/').at(-1) ?? '';

/** @param {string} text of a program @param {string} path @returns {string} the class that its file is to be named after */
export function publicClass(text, path) {
  return (
    /^\s*public\s+(?:(?:final|abstract|sealed)\s+)*(?:class|record|interface|enum)\s+(\w+)/m.exec(text)?.[1] ??
    fileName(path)
      .replace(/\.java$/, '')
      .replaceAll(/[^\p{L}\p{N}_$]/gu, '_')
  );
}

/** @param {string} text @param {string} name of the package it moves to */
export function inPackage(text, name) {
  return `package ${name};\n\n${text.replace(/^\s*package\s+[^;]*;\s*/, '')}`;
}

/**
 * Names the files of programs. Two with classes of the same name, as many systems compare names, get packages of their own.
 *
 * @param {Map<string, string>} programs texts by path
 * @returns {Map<string, [inside: string, name: string]>} package below that of the project, and class, by path
 */
function classFiles(programs) {
  const taken = new Set();
  /** @type {Map<string, [string, string]>} */
  const names = new Map();
  for (const [path, text] of programs) {
    const name = publicClass(text, path);
    const stem = publicClass('', path).toLowerCase();
    let inside = '';
    for (let number = 1; taken.has(`${inside}/${name.toLowerCase()}`); number += 1) {
      inside = number === 1 ? stem : `${stem}${number}`;
    }
    taken.add(`${inside}/${name.toLowerCase()}`);
    names.set(path, [inside, name]);
  }
  return names;
}

/**
 * Puts programs into a project.
 *
 * @param {Template} template
 * @param {Map<string, string>} programs texts by path
 * @param {string} shown path of the program that the project runs unless another one is wanted
 * @returns {Map<string, string>} texts by path
 */
export function filled(template, programs, shown) {
  const folder = `${JAVA}${template.package.replaceAll('.', '/')}/`;
  const texts = new Map(Object.entries(template.texts));
  const names = classFiles(programs);
  for (const [path, text] of programs) {
    const [inside, name] = names.get(path) ?? ['', ''];
    texts.set(
      `${folder}${inside && `${inside}/`}${name}.java`,
      inPackage(text, [template.package, inside].filter(Boolean).join('.')),
    );
  }
  const main = programs.has(shown) ? (names.get(shown) ?? []).filter(Boolean).join('/') : USUAL;
  for (const script of ['robonewbie', 'robonewbie.cmd']) {
    texts.set(script, (texts.get(script) ?? '').replaceAll(`${folder}${USUAL}.java`, `${folder}${main}.java`));
  }
  if (!/\bvoid\s+main\s*\(/.test(texts.get(`${folder}${USUAL}.java`) ?? '')) {
    texts.delete(`${folder.replace('/main/', '/test/')}${USUAL}Test.java`);
  }
  return texts;
}

/**
 * Fetches the template, and fills it.
 *
 * @param {Map<string, string>} programs texts by path
 * @param {string} shown path of the program in the editor
 * @returns {Promise<{name: string, files: Map<string, string | Uint8Array>}>}
 */
export async function project(programs, shown) {
  /** @type {Template} */
  const template = await (await fetched('project.json')).json();
  if (template.libraries.length === 0) {
    throw new Error(
      'This page was built without the program that a project needs; Copy the text of your program instead.',
    );
  }
  /** @type {Map<string, string | Uint8Array>} */
  const files = new Map();
  for (const [path, text] of filled(template, programs, shown)) {
    files.set(`${template.name}/${path}`, text);
  }
  for (const path of template.libraries) {
    const library = await fetched(fileName(path));
    files.set(`${template.name}/${path}`, new Uint8Array(await library.arrayBuffer()));
  }
  return { name: template.name, files };
}

/** @param {string} name */
async function fetched(name) {
  const answer = await fetch(FOLDER + name).catch(() => undefined);
  if (!answer?.ok) {
    throw new Error('A project needs the program itself, which this page has to fetch: is there a network?');
  }
  return answer;
}
