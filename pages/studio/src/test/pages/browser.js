/** The browser of the page tests: Chromium, or Firefox if the environment variable BROWSER is `firefox`. */
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { delimiter, join } from 'node:path';
import { after } from 'node:test';
import puppeteer, { Puppeteer } from 'puppeteer-core';
import { atEnd } from './tests.js';

export const isFirefox = process.env.BROWSER === 'firefox';

const CHROMIUM = ['chromium', 'chromium-browser', 'google-chrome', 'chrome'];
const FIREFOX = ['firefox-esr', 'firefox'];
const CHROMIUM_FLAGS = [
  '--no-sandbox',
  '--disable-dev-shm-usage',
  '--disable-gpu', // software emulation of a graphics card takes most of the time
  '--enable-unsafe-swiftshader',
];

/** Device pixels per CSS pixel in pages that no test takes a picture of. */
const COARSE = 0.25;
const PATIENCE_MILLIS = 1000 * Number(process.env.PATIENCE ?? 60);

/** Expected in every page that is drawn without a graphics card. */
const EXPECTED = /GPU stall due to ReadPixels/;
const THIS_COMPUTER = /^(https?:\/\/(127\.0\.0\.1|localhost)[:/]|file:|data:|blob:|about:|chrome:)/;

/** Folder into which Firefox saves files without asking. */
export const FIREFOX_DOWNLOADS = mkdtempSync(join(tmpdir(), 'downloads-'));
const FIREFOX_PREFERENCES = { 'browser.download.folderList': 2, 'browser.download.dir': FIREFOX_DOWNLOADS };

let shared;
after(() => shared?.close());
after(() => rmSync(FIREFOX_DOWNLOADS, { recursive: true, force: true }));

// Firefox needs a second or two to search its accessibility tree, which leaves out shadow trees.
Puppeteer.registerCustomQueryHandler('markup', { queryAll: withMarkup });

/** Returns what is visible and has a role and a name, such as `button Save`, by attributes or by its element and its text. */
function withMarkup(root, roleAndName) {
  const [, role, name] = roleAndName.match(/(\S+) (.*)/);
  const elements = {
    DisclosureTriangle: 'summary',
    button: 'button',
    checkbox: 'input[type=checkbox]',
    combobox: 'select:not([size])',
    heading: 'h1',
    link: 'a',
    list: 'ol, ul',
    listbox: 'select[size]',
    textbox: 'input:is([type=text], :not([type])), textarea',
  };
  const labelOf = (field) => {
    const label = field.labels[0].cloneNode(true);
    label.querySelectorAll('input, select, textarea').forEach((each) => each.remove());
    return label.textContent;
  };
  const hasRole = (each) => (each.role ? each.role === role : each.matches(elements[role] ?? ':not(*)'));
  const nameOf = (each) => each.ariaLabel ?? (each.labels?.length ? labelOf(each) : (each.innerText ?? ''));
  const isNamed = (each) => nameOf(each).replace(/\s+/g, ' ').trim() === name;
  const all = (tree) =>
    [...tree.querySelectorAll('*')].flatMap((each) => [each, ...(each.shadowRoot ? all(each.shadowRoot) : [])]);
  return all(root).filter((each) => hasRole(each) && isNamed(each) && each.checkVisibility());
}

function programOf(names) {
  const paths = (process.env.PATH ?? '').split(delimiter).flatMap((folder) => names.map((name) => join(folder, name)));
  const found = paths.find((path) => existsSync(path));
  if (!found) {
    throw new Error(`None of ${names.join(', ')} is installed.`);
  }
  return found;
}

/**
 * Starts a browser; {@link openPage} uses a shared one otherwise.
 *
 * @param {{ inFirefox?: boolean, flags?: string[], preferences?: object, profile?: string }} options `preferences` are those of Firefox
 */
export function launch({ inFirefox = isFirefox, flags = [], preferences = {}, profile } = {}) {
  return puppeteer.launch({
    browser: inFirefox ? 'firefox' : 'chrome',
    executablePath: programOf(inFirefox ? FIREFOX : CHROMIUM),
    args: inFirefox ? flags : [...CHROMIUM_FLAGS, ...flags],
    extraPrefsFirefox: { ...FIREFOX_PREFERENCES, ...preferences },
    userDataDir: profile,
  });
}

/**
 * Opens an empty page without history. Unless it is drawn sharply, one device pixel stands for 16 CSS pixels and the shapes of 3D pictures
 * are left out, because they take most of the time without a graphics card; positions and sizes do not change.
 *
 * @param {import('node:test').TestContext} t the test that owns the page
 * @param {{ width?: number, height?: number, isNewcomer?: boolean, isSharp?: boolean, browser?: object, profile?: string,
 *   before?: () => void }} look `browser` is one from {@link launch}; `profile` is a folder in which a separate browser keeps what pages
 *   store; `before` runs in each document before its own scripts
 */
export async function openPage(
  t,
  { width = 1366, height = 768, isNewcomer = false, isSharp = false, browser, profile, before },
) {
  const context = await (profile ? contextOf(t, profile) : newContext(t, browser));
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE_MILLIS);
  await page.setViewport({ width, height, deviceScaleFactor: isSharp ? 1 : COARSE });
  for (const script of [isNewcomer || skipTheFirstMinute, isSharp || leaveShapesOut, before]) {
    if (typeof script === 'function') {
      await page.evaluateOnNewDocument(script);
    }
  }
  page.on('dialog', (dialog) => dialog.accept());
  return { page, complaints: complaintsOf(page) };
}

async function newContext(t, browser) {
  const context = await (browser ?? (shared ??= await launch())).createBrowserContext();
  atEnd(t, () => context.close());
  return context;
}

async function contextOf(t, profile) {
  const browser = await launch({ profile });
  atEnd(t, () => browser.close());
  return browser.defaultBrowserContext();
}

function skipTheFirstMinute() {
  try {
    localStorage.setItem('robonewbie-first-minute-skipped', 'true');
  } catch {
    // An empty page has no storage.
  }
}

function leaveShapesOut() {
  for (const order of ['drawElements', 'drawArrays', 'drawElementsInstanced', 'drawArraysInstanced']) {
    WebGL2RenderingContext.prototype[order] = () => undefined;
  }
}

/** Collects errors and warnings of a page, and its requests to other computers. */
function complaintsOf(page) {
  const complaints = [];
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('console', (message) => {
    if (['error', 'warn', 'assert'].includes(message.type()) && !EXPECTED.test(message.text())) {
      complaints.push(message.text());
    }
  });
  page.on('request', (request) => {
    if (!THIS_COMPUTER.test(request.url())) {
      complaints.push(`asked for ${request.url()}`);
    }
  });
  return complaints;
}
