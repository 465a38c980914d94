/** Service worker: caches all files of the page for offline use; a newer version replaces an older one immediately. */

const LIST = 'files.json';
/** The folder of the page. Caches belong to the whole host, which may contain other editions. */
const SCOPE = self.registration.scope;
const OURS = `robonewbie ${new URL(SCOPE).pathname} `;
/** Large or rarely used files: cached on first use. */
const ON_DEMAND = /\/(compiler|docs|programs|project|vendor\/codemirror)\//;

/** @returns {Promise<{cacheName: string, files: string[]}>} */
async function list() {
  const { version, files } = await (await fetch(LIST, { cache: 'no-cache' })).json();
  return { cacheName: OURS + version, files };
}

/**
 * Returns whether a cache belongs to an older version of this edition; the first version's cache name did not contain the folder.
 *
 * @param {string} name
 */
async function isOlder(name) {
  const isNameless = /^robonewbie-\w+$/.test(name);
  return name.startsWith(OURS) || (isNameless && (await (await caches.open(name)).match(SCOPE)) !== undefined);
}

async function keepAll() {
  const { cacheName, files } = await list();
  const cache = await caches.open(cacheName);
  await cache.addAll(['./', ...files.filter((name) => !ON_DEMAND.test(`/${name}`))]);
  for (const name of (await caches.keys()).filter((other) => other !== cacheName)) {
    if (await isOlder(name)) {
      await caches.delete(name);
    }
  }
  await self.skipWaiting();
}

/** @param {Request} request */
async function kept(request) {
  return (await caches.match(request, { ignoreSearch: true })) ?? fetched(request);
}

/** @param {Request} request */
async function fetched(request) {
  const answer = await fetch(request);
  if (answer.ok && request.url.startsWith(SCOPE) && ON_DEMAND.test(`/${request.url.slice(SCOPE.length)}`)) {
    const { cacheName } = await list();
    await (await caches.open(cacheName)).put(request, answer.clone());
  }
  return answer;
}

/** Caches the files of the given folders that have not been cached yet. @param {string[]} folders */
async function keepFolders(folders) {
  const { cacheName, files } = await list();
  const cache = await caches.open(cacheName);
  for (const name of files.filter((each) => folders.some((folder) => each.startsWith(folder)))) {
    if (!(await cache.match(name))) {
      await cache.add(name);
    }
  }
}

self.addEventListener('message', (event) => event.waitUntil(keepFolders(event.data.keep)));
self.addEventListener('install', (event) => event.waitUntil(keepAll()));
self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim()));
self.addEventListener('fetch', (event) => event.respondWith(kept(event.request)));
