// Colour scheme, and navigation on small screens. A plain script, because pages opened from a folder cannot load modules.
(() => {
  const KEY = 'robonewbie-theme';
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

  document.addEventListener('DOMContentLoaded', () => {
    themeSwitch();
    if (matchMedia('(max-width: 48rem)').matches) document.querySelector('.pages').open = false;
    document.querySelector('.pages a[aria-current]')?.scrollIntoView({ block: 'nearest' });
  });
})();
