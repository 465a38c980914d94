// Colour scheme, navigation on small screens, and search. A plain script, because pages opened from a folder cannot load modules.
(() => {
  const KEY = 'robonewbie-theme';
  const MAX_HITS = 12;
  const LETTERS_AROUND = 60;
  const top = document.currentScript.dataset.top;
  const root = document.documentElement;

  const kept = () => {
    try {
      return localStorage.getItem(KEY);
    } catch {
      return null; // storage is switched off
    }
  };
  const keep = (theme) => {
    try {
      localStorage.setItem(KEY, theme);
    } catch {
      // without storage the choice applies to this page only
    }
  };
  if (kept()) root.dataset.theme = kept();

  const isDark = () =>
    root.dataset.theme ? root.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;

  function themeSwitch() {
    const button = document.getElementById('theme');
    const name = () => (button.textContent = isDark() ? 'Light' : 'Dark');
    button.addEventListener('click', () => {
      root.dataset.theme = isDark() ? 'light' : 'dark';
      keep(root.dataset.theme);
      name();
    });
    button.hidden = false;
    name();
  }

  /** Returns the sections that contain all words; matches in headings have the greatest weight. */
  function find(words) {
    return globalThis.searchIndex
      .map((section) => {
        const heading = `${section.page} ${section.title}`.toLowerCase();
        const text = section.text.toLowerCase();
        const points = words.map((word) => (heading.includes(word) ? 10 : 0) + (text.includes(word) ? 1 : 0));
        return { section, points: points.includes(0) ? 0 : points.reduce((sum, next) => sum + next, 0) };
      })
      .filter((hit) => hit.points > 0)
      .sort((one, other) => other.points - one.points)
      .slice(0, MAX_HITS)
      .map((hit) => hit.section);
  }

  function excerpt(text, word) {
    const at = Math.max(0, text.toLowerCase().indexOf(word) - LETTERS_AROUND);
    return (at > 0 ? '… ' : '') + text.slice(at, at + 3 * LETTERS_AROUND);
  }

  function show(found, words) {
    const hits = words.length ? find(words) : [];
    const lines = hits.map((section) => {
      const line = document.createElement('p');
      const link = document.createElement('a');
      const small = document.createElement('small');
      link.href = top + section.address;
      link.textContent = section.page === section.title ? section.page : `${section.page}: ${section.title}`;
      small.textContent = excerpt(section.text, words[0]);
      line.append(link, small);
      return line;
    });
    found.replaceChildren(...(lines.length ? lines : ['Nothing found. Try another word.']));
    found.hidden = words.length === 0;
  }

  function loadIndex(then) {
    if (globalThis.searchIndex) return then();
    const script = document.createElement('script');
    script.src = `${top}search-index.js`;
    script.addEventListener('load', then);
    document.head.append(script);
  }

  function search() {
    const field = document.getElementById('search');
    const found = document.getElementById('found');
    const words = () => field.value.toLowerCase().split(/\s+/).filter(Boolean);
    field.addEventListener('input', () => loadIndex(() => show(found, words())));
    field.addEventListener('keydown', (event) => {
      if (event.key === 'Enter') found.querySelector('a')?.click();
    });
    document.addEventListener('keydown', (event) => {
      if (event.key === '/' && document.activeElement !== field) {
        event.preventDefault();
        field.focus();
      } else if (event.key === 'Escape') {
        found.hidden = true;
      }
    });
    found.addEventListener('click', () => (found.hidden = true));
    field.hidden = false;
  }

  document.addEventListener('DOMContentLoaded', () => {
    themeSwitch();
    search();
    if (matchMedia('(max-width: 48rem)').matches) document.querySelector('.pages').open = false;
    document.querySelector('.pages a[aria-current]')?.scrollIntoView({ block: 'nearest' });
  });
})();
