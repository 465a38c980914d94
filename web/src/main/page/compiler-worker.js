/** Java's compiler, off the page's own thread: `{id, sources}` is answered by `{id, remarks, classes}`. */
import { load } from './compiler/webassembly-loader.js';

/** @param {string} name */
const place = (name) => new URL(`compiler/${name}`, import.meta.url).href;

const compiler = begin();

async function begin() {
  const [program, library] = await Promise.all([
    load(place('javac.wasm')),
    fetch(place('library.bin')).then((answer) => answer.arrayBuffer()),
  ]);
  program.exports.takeLibrary(new Int8Array(library));
  return program.exports;
}

/** @param {any} exports @param {[string, string][]} sources */
function compile(exports, sources) {
  for (const [path, text] of sources) {
    exports.takeSource(path, text);
  }
  const count = exports.compile();
  const remarks = Array.from({ length: count }, (_, i) => exports.remark(i));
  const files = exports.classFiles().split(' ').filter(Boolean);
  return { remarks, classes: files.map((/** @type {string} */ _, /** @type {number} */ i) => exports.classFile(i)) };
}

onmessage = async ({ data }) => {
  try {
    postMessage({ id: data.id, ...compile(await compiler, data.sources) });
  } catch (failure) {
    postMessage({ id: data.id, failure: String(failure) });
  }
};
