/**
 * Web worker with the Java compiler: replies to `{id, sources}` with `{id, remarks, classes}` or, if `at` is given, with `{id, proposals}`.
 */
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

/** @param {any} exports @param {[string, string][]} sources the edited one first @param {number} at index of the cursor */
function complete(exports, sources, at) {
  for (const [path, text] of sources) {
    exports.takeSource(path, text);
  }
  const count = exports.complete(sources[0][0], at);
  return { proposals: Array.from({ length: count }, (_, i) => exports.proposal(i)) };
}

onmessage = async ({ data }) => {
  try {
    const exports = await compiler;
    const { id, sources, at } = data;
    postMessage({ id, ...(at === undefined ? compile(exports, sources) : complete(exports, sources, at)) });
  } catch (failure) {
    postMessage({ id: data.id, failure: String(failure) });
  }
};
