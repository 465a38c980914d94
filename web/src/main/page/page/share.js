/** A link that holds a program: its name and text, packed, behind the sign # of the page's address. Nothing is sent to any server. */

const MARK = 'shared=';

/** @param {ReadableStream<any>} stream */
const bytesOf = async (stream) => new Uint8Array(await new Response(stream).arrayBuffer());

/** @param {string} text */
async function packed(text) {
  const bytes = await bytesOf(new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw')));
  return btoa(String.fromCharCode(...bytes))
    .replaceAll('+', '-')
    .replaceAll('/', '_')
    .replace(/=+$/, '');
}

/** @param {string} text */
async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
  return new TextDecoder().decode(
    await bytesOf(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))),
  );
}

/** @param {string} path @param {string} text @returns {Promise<string>} the link */
export async function linkOf(path, text) {
  const address = new URL(location.href);
  address.search = '';
  address.hash = `program?${MARK}${await packed(`${path}\n${text}`)}`;
  return address.href;
}

/** Reads the program out of the page's address, if it holds one, and takes it away from there. @returns {Promise<{path: string, text: string} | undefined>} */
export async function sharedProgram() {
  const [, content] = location.hash.split(`?${MARK}`);
  if (!content) {
    return undefined;
  }
  history.replaceState(undefined, '', '#program');
  const [path, ...lines] = (await unpacked(content)).split('\n');
  return { path, text: lines.join('\n') };
}
