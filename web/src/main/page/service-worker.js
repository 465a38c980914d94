/** Keeps all files of the page, so that it also opens without a network; a newer page takes the place of an older one at once. */

const LIST = 'files.json';
/** Large, or seldom wanted: kept from the first time on that somebody asks for it. */
const ON_DEMAND = /\/(compiler|docs|examples|programs|project|vendor\/codemirror)\//;

/** @returns {Promise<{version: string, files: string[]}>} */
const list = async () => (await fetch(LIST, { cache: 'no-cache' })).json();

async function keepAll() {
  const { version, files } = await list();
  const cache = await caches.open(version);
  await cache.addAll(['./', ...files.filter((name) => !ON_DEMAND.test(`/${name}`))]);
  const others = (await caches.keys()).filter((name) => name !== version && name.startsWith('robonewbie-'));
  await Promise.all(others.map((name) => caches.delete(name)));
  await self.skipWaiting();
}

/** @param {Request} request */
async function kept(request) {
  return (await caches.match(request, { ignoreSearch: true })) ?? fetched(request);
}

/** @param {Request} request */
async function fetched(request) {
  const answer = await fetch(request);
  if (answer.ok && ON_DEMAND.test(new URL(request.url).pathname)) {
    const { version } = await list();
    await (await caches.open(version)).put(request, answer.clone());
  }
  return answer;
}

/** Keeps what is in some folders and was not kept before. @param {string[]} folders */
async function keepFolders(folders) {
  const { version, files } = await list();
  const cache = await caches.open(version);
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
