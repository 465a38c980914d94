/** A static file server whose files lie below a path, as on any web host. */
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, sep } from 'node:path';
import { atEnd } from './tests.js';

const PLACE = '/some/where/';
const TYPES = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
};

/** Serves folders, files of an earlier one before those of a later one, until the test ends or `close` is called. */
export async function serve(t, ...folders) {
  const server = createServer(async (request, response) => {
    const name = decodeURIComponent(new URL(request.url ?? '/', 'http://host').pathname).slice(PLACE.length);
    const content = await firstFile(folders, name === '' || name.endsWith('/') ? `${name}index.html` : name);
    const type = TYPES[extname(name) || '.html'] ?? 'application/octet-stream';
    response.writeHead(content ? 200 : 404, { 'Content-Type': type }).end(content);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', done));
  const close = async () => {
    server.closeAllConnections();
    await new Promise((done) => server.close(done));
  };
  atEnd(t, close);
  return { address: `http://127.0.0.1:${server.address().port}${PLACE}`, close };
}

async function firstFile(folders, name) {
  for (const folder of folders) {
    const path = normalize(join(folder, name));
    if (path.startsWith(folder + sep)) {
      const content = await readFile(path).catch(() => undefined);
      if (content) {
        return content;
      }
    }
  }
  return undefined;
}
