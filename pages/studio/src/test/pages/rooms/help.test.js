/** Readers find a page of Help by the words that they type, in the studio and in a folder without a server. */
import assert from 'node:assert/strict';
import { findsNoBarrier } from '../accessibility.js';
import { quick, slow } from '../tests.js';
import { newUser, openStudio } from '../user.js';

const FOLDER = new URL('../../../../../site/target/classes/org/robonewbie/site/pages/', import.meta.url).href;
const FIELDS = { en: 'Search the documentation', de: 'Dokumentation durchsuchen' };
const HITS = '#found a';

/** Pages, what a reader types there, and the page that the first hit leads to. */
const QUESTIONS = [
  ['index.html', 'setJointSpeed', 'tutorial/2-motion.html'],
  ['index.html', 'competition rules', 'competition.html'],
  ['for/students.html', 'how do I install Java', 'installation.html'],
  ['tutorial/1-perception.html', 'kicking', 'exercises/12-kick.html'],
  ['glossary.html', 'exerzise', 'exercises/'],
  ['exercises/de/01-raise-arms.html', 'hande heben', 'exercises/de/01-raise-arms.html'],
  ['exercises/de/index.html', 'Schuss', 'exercises/de/12-kick.html'],
];

const PAGES = ['', 'for/students.html', 'studio.html', 'competition.html', 'tutorial/', 'reference.html'];

/** Types a question over the last one, and returns the first hit. */
async function asks(user, question, language = 'en') {
  const field = await user.finds('searchbox', FIELDS[language]);
  await field.click({ count: 3 });
  await user.types(question);
  return user.page.waitForSelector(HITS, { visible: true });
}

async function findsTheAnswer(user, [from, question, answer]) {
  await user.visits(FOLDER + from);

  const hit = await asks(user, question, from.includes('/de/') ? 'de' : 'en');

  await user.until(() => hit.evaluate((link, page) => !link.isConnected || link.href.includes(page), answer));
  await user.page.waitForSelector(`${HITS}[href*="${answer}"]`, { visible: true });
  await user.page.waitForSelector('#found mark', { visible: true });
}

/** Opens a page of Help in the studio. */
async function visitsHelp({ user, stage }, page, theme = 'light') {
  const address = await stage.address();
  await user.visits(`${address}&quality=lowest&theme=${theme}`);
  await user.visits(new URL(`/docs/${page}`, address).href);
}

quick('a question in a page of Help finds its page', async (t) => {
  await findsTheAnswer(await newUser(t), QUESTIONS[0]);
});

slow('questions in any page of Help, in both languages and with mistakes, find their pages', async (t) => {
  const user = await newUser(t);
  for (const question of QUESTIONS) {
    await findsTheAnswer(user, question);
  }
});

slow('an unknown word is told in the language of the page', async (t) => {
  const user = await newUser(t);
  await user.visits(`${FOLDER}exercises/de/index.html`);

  await user.clicks('searchbox', FIELDS.de);
  await user.types('qqqqqqqq');

  await user.sees('Nichts gefunden');
});

slow('the keyboard leads from any place of Help to a hit', async (t) => {
  const studio = await openStudio(t);
  const { user } = studio;
  await visitsHelp(studio, 'for/students.html');

  await user.presses('/');
  await user.types('tutorial');
  await user.page.waitForSelector(HITS, { visible: true });
  await findsNoBarrier(user, 'the hits');
  await user.presses('Escape');
  await user.page.waitForSelector(HITS, { hidden: true });
  const hit = await asks(user, 'glossary');
  await user.presses('ArrowDown');
  await user.until(() => hit.evaluate(() => document.activeElement === document.querySelector('#found a')));
  await user.presses('Enter');

  await user.until(() => /\/glossary\.html(#|$)/.test(user.page.url()));
});

for (const theme of ['light', 'dark']) {
  slow(`no page of Help has a barrier in the ${theme} theme`, async (t) => {
    const studio = await openStudio(t);
    for (const page of PAGES) {
      await visitsHelp(studio, page, theme);
      await studio.user.page.waitForSelector('main, article, h1');
      assert.equal(await studio.user.page.evaluate(() => location.pathname), `/docs/${page}`);

      await findsNoBarrier(studio.user, `docs/${page}`);
    }
  });
}
