/** Exports all programs of this browser as a project like that of `robonewbie new`, which can be built and run without this page. */

/**
 * @typedef {object} Template project template, created by `robonewbie new` when this page was built
 * @property {string} name
 * @property {string} package
 * @property {Record<string, string>} texts text of each file by path
 * @property {string[]} libraries paths of binary files
 */

const FOLDER = 'project/';
const JAVA = 'src/main/java/';
const DEFAULT_CLASS = 'MyAgent';

/** @param {string} path @returns {string} */
const fileName = (path) => path.split('/').at(-1) ?? '';

/** @param {string} text text of a program @param {string} path @returns {string} the class after which its file must be named */
export function publicClass(text, path) {
  return (
    /^\s*public\s+(?:(?:final|abstract|sealed)\s+)*(?:class|record|interface|enum)\s+(\w+)/m.exec(text)?.[1] ??
    fileName(path)
      .replace(/\.java$/, '')
      .replaceAll(/[^\p{L}\p{N}_$]/gu, '_')
  );
}

/**
 * @param {Map<string, string>} files text of each file by path
 * @param {string} path path of a program
 * @returns {Map<string, string>} the program and the Java files that it uses, directly or indirectly
 */
export function withReferences(files, path) {
  const found = new Map([[path, files.get(path) ?? '']]);
  const classes = new Set([publicClass(files.get(path) ?? '', path)]);
  for (const text of found.values()) {
    const words = new Set(text.match(/[\p{L}\p{N}_$]+/gu));
    for (const [other, content] of files) {
      const name = publicClass(content, other);
      if (other.endsWith('.java') && words.has(name) && !classes.has(name)) {
        classes.add(name);
        found.set(other, content);
      }
    }
  }
  return found;
}

/** @param {string} text @param {string} name name of its new package */
export function inPackage(text, name) {
  return `package ${name};\n\n${text.replace(/^\s*package\s+[^;]*;\s*/, '')}`;
}

/**
 * Assigns files to programs. Programs whose class names differ at most in case get separate packages.
 * @param {Map<string, string>} programs text of each program by path @returns {Map<string, [inside: string, name: string]>} subpackage and
 *     class, by path
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
 * Adds programs to a project template.
 *
 * @param {Template} template
 * @param {Map<string, string>} programs text of each program by path @param {string} shown path of the program that the project runs by
 *     default
 * @returns {Map<string, string>} text of each file by path
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
  const main = programs.has(shown) ? (names.get(shown) ?? []).filter(Boolean).join('/') : DEFAULT_CLASS;
  for (const script of ['robonewbie', 'robonewbie.cmd']) {
    texts.set(script, (texts.get(script) ?? '').replaceAll(`${folder}${DEFAULT_CLASS}.java`, `${folder}${main}.java`));
  }
  if (!/\bvoid\s+main\s*\(/.test(texts.get(`${folder}${DEFAULT_CLASS}.java`) ?? '')) {
    texts.delete(`${folder.replace('/main/', '/test/')}${DEFAULT_CLASS}Test.java`);
  }
  return texts;
}

/**
 * Loads the template and adds the programs.
 * @param {Map<string, string>} programs text of each program by path @param {string} shown path of the program in the editor
 * @returns {Promise<{name: string, files: Map<string, string | Uint8Array>}>}
 */
export async function project(programs, shown) {
  /** @type {Template} */
  const template = await (await fetched('project.json')).json();
  if (template.libraries.length === 0) {
    throw new Error('This page was built without the project files. Copy the text of your program instead.');
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
    throw new Error('The project files could not be loaded. Are you connected to the network?');
  }
  return answer;
}
