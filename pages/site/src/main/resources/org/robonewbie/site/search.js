// Full-text search over the sections of all pages. A plain script, because pages opened from a folder cannot load modules.
(() => {
  const { top, part } = document.currentScript.dataset;
  const language = document.documentElement.lang;
  const SCRIPTS = ['vendor/minisearch/minisearch.js', 'search-index.js'];
  const MAX_HITS = 12;
  const MAX_HITS_OF_PAGE = 2;
  const FEW_HITS = 3;
  const LETTERS_BEFORE = 60;
  const LETTERS = 180;
  const STOP_WORDS = new Set(
    (
      'a an and are at be by can do does for from how i in is it its make me my of on or that the there this to what when where which ' +
      'why with you your auf das dem den der die ein eine einen für ich im ist man mit und von was wie wo zu'
    ).split(' '),
  );
  const WORDS = {
    en: {
      hint: 'Search (press /)',
      label: 'Search the documentation',
      nothing: 'Nothing found. Try another word.',
      count: (hits) => (hits === 1 ? '1 result' : `${hits} results`),
    },
    de: {
      hint: 'Suchen (Taste /)',
      label: 'Dokumentation durchsuchen',
      nothing: 'Nichts gefunden. Versuche ein anderes Wort.',
      count: (hits) => `${hits} Treffer`,
    },
  }[language];

  /** Folds case and accents without changing the length. */
  const folded = (text) =>
    text
      .normalize('NFD')
      .replace(/\p{Mn}/gu, '')
      .toLowerCase();

  /** Splits text into words; also returns the parts of names such as getJointAngle. */
  function tokenize(text) {
    return text.split(/[^\p{L}\p{N}]+/u).flatMap((word) => {
      const parts = word.replace(/(\p{Ll})(\p{Lu})/gu, '$1 $2').split(' ');
      return parts.length > 1 ? [word, ...parts] : parts;
    });
  }

  function processTerm(word) {
    return STOP_WORDS.has(word.toLowerCase()) ? null : folded(word).replace(/^(.{4,})(?:ing|ed|s)$/, '$1');
  }

  /** Ranks sections higher if they are in the same language or intended for the same readers as this page. */
  function boostDocument(id) {
    const section = globalThis.searchIndex[id];
    return (section.language === language ? 1 : 0.3) * (section.part === part ? 2 : 1);
  }

  function makeEngine() {
    const engine = new globalThis.MiniSearch({ fields: ['page', 'title', 'text'], tokenize, processTerm });
    engine.addAll(globalThis.searchIndex.map((section, id) => ({ ...section, id })));
    return engine;
  }

  /** Returns the best hits, which may contain only some of the words; misspelt words match only if there are few exact hits. */
  function find(engine, query) {
    const search = (fuzzy) =>
      engine.search(query, { fuzzy, boostDocument, boost: { page: 5, title: 4 }, prefix: true });
    const exact = search(false);
    const hits = exact.length < FEW_HITS ? search(0.2) : exact;
    const ofPage = new Map();
    return hits
      .map((hit) => ({ ...globalThis.searchIndex[hit.id], terms: hit.terms }))
      .filter(({ page }) => ofPage.set(page, (ofPage.get(page) ?? 0) + 1).get(page) <= MAX_HITS_OF_PAGE)
      .slice(0, MAX_HITS);
  }

  function element(name, ...content) {
    const made = document.createElement(name);
    made.append(...content);
    return made;
  }

  /** Returns the text around the first term, with all terms marked. */
  function excerpt(text, terms) {
    const places = [...folded(text).matchAll(new RegExp(`\\b(?:${terms.join('|')})\\w*`, 'g'))];
    const before = (places[0]?.index ?? 0) - LETTERS_BEFORE;
    const start = before > 0 ? text.indexOf(' ', before) + 1 : 0;
    const end = start + LETTERS;
    const content = [start > 0 ? '… ' : ''];
    let at = start;
    for (const { 0: word, index } of places.filter((place) => place.index < end)) {
      content.push(text.slice(at, index), element('mark', text.slice(index, index + word.length)));
      at = index + word.length;
    }
    return element('small', ...content, text.slice(at, end), end < text.length ? ' …' : '');
  }

  function line({ address, page, title, text, terms, part: readers }) {
    const link = element('a', page === title ? page : `${page}: ${title}`);
    link.href = top + address;
    return element('li', link, readers ? element('span', readers) : '', excerpt(text, terms));
  }

  function show(found, engine, query) {
    const hits = query ? find(engine, query) : [];
    const status = element('p', hits.length ? WORDS.count(hits.length) : WORDS.nothing);
    status.setAttribute('role', 'status');
    found.replaceChildren(status, element('ol', ...hits.map(line)));
    found.hidden = !query;
  }

  const load = (name) =>
    new Promise((loaded) => {
      const script = document.createElement('script');
      script.src = top + name;
      script.addEventListener('load', loaded);
      document.head.append(script);
    });
  let made;
  const engine = () => (made ??= Promise.all(SCRIPTS.map(load)).then(makeEngine));

  /** Moves the focus between the search field and the hits. */
  function step(field, found, steps) {
    const places = [field, ...found.querySelectorAll('a')];
    places[Math.max(0, Math.min(places.length - 1, places.indexOf(document.activeElement) + steps))].focus();
  }

  function whenKeyPressed(event, field, found) {
    const { key, target } = event;
    const isInside = target === field || found.contains(target);
    if (key === '/' && target !== field) {
      field.focus();
      field.select();
    } else if (key === 'Escape' && !found.hidden) {
      found.hidden = true;
      field.focus();
    } else if (isInside && !found.hidden && (key === 'ArrowDown' || key === 'ArrowUp')) {
      step(field, found, key === 'ArrowDown' ? 1 : -1);
    } else if (key === 'Enter' && target === field) {
      found.querySelector('a')?.click();
    } else {
      return;
    }
    event.preventDefault();
  }

  document.addEventListener('DOMContentLoaded', () => {
    const field = document.getElementById('search');
    const found = document.getElementById('found');
    field.placeholder = WORDS.hint;
    field.setAttribute('aria-label', WORDS.label);
    field.hidden = false;
    field.addEventListener('focus', engine);
    field.addEventListener('input', async () => show(found, await engine(), field.value.trim()));
    document.addEventListener('keydown', (event) => whenKeyPressed(event, field, found));
    document.addEventListener('click', ({ target }) => {
      if (target !== field && (!found.contains(target) || target.closest('a'))) {
        found.hidden = true;
      }
    });
  });
})();
