/** Keeps all files of the page, so that it also opens without a network; a newer page takes the place of an older one at once. */

const LIST = 'files.json';
const ON_DEMAND = '/compiler/';

/** @returns {Promise<{version: string, files: string[]}>} */
const list = async () => (await fetch(LIST, { cache: 'no-cache' })).json();

async function keepAll() {
  const { version, files } = await list();
  const cache = await caches.open(version);
  await cache.addAll(['./', ...files.filter((name) => !`/${name}`.startsWith(ON_DEMAND))]);
  const others = (await caches.keys()).filter((name) => name !== version && name.startsWith('robonewbie-'));
  await Promise.all(others.map((name) => caches.delete(name)));
  await self.skipWaiting();
}

/** @param {Request} request */
async function kept(request) {
  return (await caches.match(request, { ignoreSearch: true })) ?? fetched(request);
}

/** The compiler is large, and kept from the first time on that somebody programs. @param {Request} request */
async function fetched(request) {
  const answer = await fetch(request);
  if (answer.ok && new URL(request.url).pathname.includes(ON_DEMAND)) {
    const { version } = await list();
    await (await caches.open(version)).put(request, answer.clone());
  }
  return answer;
}

self.addEventListener('install', (event) => event.waitUntil(keepAll()));
self.addEventListener('activate', (event) => event.waitUntil(self.clients.claim()));
self.addEventListener('fetch', (event) => event.respondWith(kept(event.request)));
