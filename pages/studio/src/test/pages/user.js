/** A person before a page, who sees what is visible and uses what has a role and a name. */
import assert from 'node:assert/strict';
import { mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { FIREFOX_DOWNLOADS, openPage } from './browser.js';
import { folderWith, openStage } from './stage.js';
import { serve } from './static-server.js';
import { atEnd } from './tests.js';

/** Folder of the web edition. */
export const WEB_EDITION =
  process.env.WEB_EDITION ?? fileURLToPath(new URL('../../../../web/target/web', import.meta.url));
/** Look of a studio of which a test takes pictures; nothing if no pictures are kept, because drawing them takes most of the time. */
export const FOR_PICTURES = process.env.PICTURES ? { isSharp: true, quality: 'high' } : {};
/** Name of the text field with the program in the Program room. */
export const EDITOR = 'Program. Press Escape, then Tab, to leave the editor.';
const POLL_MILLIS = 25;
const PATIENCE_SECONDS = Number(process.env.PATIENCE ?? 60);

/**
 * Opens the studio on a fresh page.
 *
 * @param {import('node:test').TestContext} t
 * @param {import('./stage.js').World & { room?: string, files?: Record<string, string | Uint8Array>, quality?: string, theme?: string,
 *   width?: number, height?: number, isNewcomer?: boolean, isSharp?: boolean, browser?: object, before?: () => void }} options
 *   the files lie in the folder of programs, motions, recordings and progress
 */
export async function openStudio(t, options = {}) {
  const { files, room = 'field', quality = 'lowest', theme = 'light', ...others } = options;
  const { width, height, isNewcomer, isSharp, browser, before, ...world } = others;
  const folder = await folderWith(t, files);
  const stage = await openStage(t, folder, world);
  const user = await newUser(t, { width, height, isNewcomer, isSharp, browser, before });
  const visit = async (to = room) => user.visits(`${await stage.address()}&quality=${quality}&theme=${theme}#${to}`);
  await visit();
  return { folder, stage, user, visit };
}

/**
 * Opens the web edition on a fresh page.
 *
 * @param {import('node:test').TestContext} t
 * @param {{ to?: string, files?: Record<string, string>, width?: number, height?: number, isNewcomer?: boolean, isSharp?: boolean,
 *   browser?: object, profile?: string, before?: () => void }} options `to` is what follows the address of the folder, such as
 *   `#program`; `files` are served before those of the page
 */
export async function openWebEdition(t, { to = '', files, ...look } = {}) {
  const folder = await folderWith(t, files);
  const server = await serve(t, folder, WEB_EDITION);
  const user = await newUser(t, look);
  const visit = (place = to) => user.visits(server.address + place);
  await visit();
  return { folder, server, user, visit };
}

/** Opens an empty page for a user, of which the page must not complain until the test ends; call it once the servers of the page run. */
export async function newUser(t, look = {}) {
  const { page, complaints } = await openPage(t, look);
  const isFirefox = /firefox/i.test(await page.browser().version());
  return new User(t, page, complaints, isFirefox);
}

const matches = (text, wanted) => (typeof wanted === 'string' ? text.includes(wanted) : wanted.test(text));

/** Returns all visible text, including that in shadow trees. */
function visibleText() {
  const texts = [document.body.innerText];
  const walk = (root) => {
    for (const host of [...root.querySelectorAll('*')].filter((each) => each.shadowRoot && each.checkVisibility())) {
      texts.push(...[...host.shadowRoot.children].map((child) => child.innerText ?? ''));
      walk(host.shadowRoot);
    }
  };
  walk(document);
  return texts.join('\n').replaceAll('\u00a0', ' ');
}

async function coloursOf(png) {
  const bytes = Uint8Array.from(atob(png), (each) => each.charCodeAt(0));
  const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
  const pen = new OffscreenCanvas(image.width, image.height).getContext('2d');
  pen.drawImage(image, 0, 0);
  const { data } = pen.getImageData(0, 0, image.width, image.height);
  return Array.from({ length: data.length / 4 }, (_, i) => [...data.slice(4 * i, 4 * i + 3)]);
}

/** Firefox ignores the text in the constructor of a `ClipboardEvent`. */
function paste(field, text) {
  const clipboardData = new DataTransfer();
  clipboardData.setData('text/plain', text);
  field.dispatchEvent(Object.assign(new Event('paste', { bubbles: true, cancelable: true }), { clipboardData }));
}

/** Returns the visible text of an element, or all options of a list or menu. */
function textOf(element) {
  return element.options ? Array.from(element.options, ({ text }) => text).join('\n') : element.innerText;
}

/** Returns false if an error is due to the replacement of the page, and throws it otherwise. */
function falseIfReplaced(error) {
  if (!/context was destroyed/.test(String(error))) {
    throw error;
  }
  return false;
}

class User {
  #expected = /^$/;
  #isFirefox;

  constructor(t, page, complaints, isFirefox) {
    this.page = page;
    this.#isFirefox = isFirefox;
    this.complaints = complaints;
    atEnd(t, () =>
      assert.deepEqual(
        complaints.filter((each) => !this.#expected.test(each)),
        [],
      ),
    );
  }

  /** Lets the page complain of what matches. */
  expectsComplaints(pattern) {
    this.#expected = pattern;
  }

  /** Leaves the page, once it has kept all work, for another address, even if only the fragment differs; waits until its room is open. */
  async visits(address) {
    await this.until(
      async () => !(await this.isAskedBeforeClosing()),
      () => 'leaves a page that has kept all work',
    );
    await this.page.goto('about:blank');
    await this.page.goto(address);
    await this.#waitsForTheRoom();
  }

  /** Follows a link to another place of the page, such as `#replay/game@2`. */
  async follows(fragment) {
    await this.page.evaluate((to) => {
      location.hash = to;
    }, fragment);
  }

  /** Waits until no part of the page is busy; a page that is being replaced is asked again. */
  async #waitsForTheRoom() {
    const isCalm = () => this.page.evaluate(() => document.querySelector('[aria-busy="true"]') === null);
    await this.until(
      () => isCalm().catch(() => false),
      () => 'waits for the room',
    );
  }

  /** Returns all visible text. */
  text() {
    return this.page.evaluate(visibleText);
  }

  /** Waits until text is visible: a string that is contained, or a pattern. */
  async sees(text) {
    await this.until(
      async () => matches(await this.text(), text),
      () => `sees ${text}`,
    );
  }

  /** Waits until text is not visible. */
  async seesNo(text) {
    await this.until(
      async () => !matches(await this.text(), text),
      () => `sees no ${text}`,
    );
  }

  /** Returns Puppeteer's selector of what has a role and a name: in the accessibility tree, or in the markup of Firefox. */
  #named(role, name) {
    return this.#isFirefox
      ? `markup/${role} ${name}`
      : `::-p-aria([role="${role}"][name="${name.replaceAll('"', '\\"')}"])`;
  }

  /** Waits until what has this role and name is visible, and returns its handle. */
  async finds(role, name) {
    return this.#told(`finds ${role} "${name}"`, () =>
      this.page.waitForSelector(this.#named(role, name), { visible: true }),
    );
  }

  /** Waits until nothing visible has this role and name. */
  async findsNo(role, name) {
    await this.#told(`finds no ${role} "${name}"`, () =>
      this.page.waitForSelector(this.#named(role, name), { hidden: true }),
    );
  }

  /** Clicks what has this role and name, as soon as it is visible and enabled. */
  async clicks(role, name) {
    await this.#waitsForTheRoom();
    await this.#told(`clicks ${role} "${name}"`, () => this.page.locator(this.#named(role, name)).click());
  }

  /** Fills a field, chooses an option by its value or moves a slider, as soon as it is enabled. */
  async fills(role, name, value) {
    await this.#told(`fills ${role} "${name}"`, () => this.page.locator(this.#named(role, name)).fill(value));
  }

  /** Replaces the program in the editor, as by pasting, once there is one. */
  async writes(text) {
    const editor = await this.finds('textbox', EDITOR);
    await this.reads('textbox', EDITOR, /\S/);
    await editor.focus();
    await this.presses('Control+a');
    await editor.evaluate(paste, text);
  }

  /** Saves a file without showing it, such as `MyAgent.java` of the kind `program`. */
  async stores(kind, path, text) {
    await this.page.evaluate(
      async (file, content) => {
        const { ServerFiles } = await import('./live/server-files.js');
        const files = new ServerFiles(file.kind);
        const known = (await files.list()).files.find((each) => each.path === file.path);
        await files.write(file.path, content, known?.version ?? '');
      },
      { kind, path },
      text,
    );
  }

  /** Types text where the focus is. */
  async types(text) {
    await this.page.keyboard.type(text);
  }

  /** Presses keys one after the other, such as `Escape` or `Control+s`. */
  async presses(...strokes) {
    for (const stroke of strokes) {
      const keys = stroke.split(/(?<=.)\+/);
      for (const key of keys) {
        await this.page.keyboard.down(key);
      }
      for (const key of keys.reverse()) {
        await this.page.keyboard.up(key);
      }
    }
  }

  /** Drags the mouse from a point `[x, y]` of the page to another, with keys held down. */
  async drags(from, to, ...keys) {
    const { keyboard, mouse } = this.page;
    await mouse.move(...from);
    for (const key of keys) {
      await keyboard.down(key);
    }
    await mouse.down();
    await mouse.move(...to, { steps: 4 });
    await mouse.up();
    for (const key of keys) {
      await keyboard.up(key);
    }
  }

  /** Moves the camera, as `{ target, azimuthDegrees, elevationDegrees, distance }` or a part of it, and waits until the picture is drawn. */
  async looks(view) {
    await this.page.evaluate((place) => {
      studio.camera.jumpTo({ ...studio.camera.view, ...place });
      studio.touch();
    }, view);
    await this.page.waitForFunction(() => studio.camera.isStill && !studio.session.stale);
  }

  /** Returns the point `[x, y]` of the page at which the 3D picture shows a point of the pitch, in metres, once the camera is still. */
  async pointOf(x, y, z) {
    await this.page.waitForFunction(() => studio.camera.isStill);
    return this.page.evaluate(
      (...point) => {
        const { stage, camera } = studio.view;
        const box = stage.getBoundingClientRect();
        const at = new camera.position.constructor(...point).project(camera);
        return [box.left + ((at.x + 1) / 2) * box.width, box.top + ((1 - at.y) / 2) * box.height];
      },
      x,
      y,
      z,
    );
  }

  /** Waits until the visible text of an element matches, and returns it; that of a list or menu has a line for each option. */
  async reads(role, name, text = '') {
    const element = await this.finds(role, name);
    let read = '';
    await this.until(
      async () => matches((read = await element.evaluate(textOf)), text),
      () => `reads ${text} in ${role} "${name}", which says ${read}`,
    );
    return read;
  }

  /** Waits until a field has a value. */
  async readsValue(role, name, value) {
    const field = await this.finds(role, name);
    let read = '';
    await this.until(
      async () => (read = await field.evaluate((node) => String(node.value))) === value,
      () => `reads ${value} in ${role} "${name}", which has ${read}`,
    );
  }

  /** Returns the name and the bytes of the file that an action saves on this computer. */
  async downloads(action) {
    return this.#isFirefox ? this.#downloadsInFirefox(action) : this.#downloadsInChromium(action);
  }

  async #downloadsInFirefox(action) {
    await action();
    let files = [];
    const isComplete = async () => {
      files = await readdir(FIREFOX_DOWNLOADS);
      return files.length === 1 && !files[0].endsWith('.part');
    };
    await this.until(isComplete, () => `downloads a file; the folder contains ${files.join(', ') || 'nothing'}`);
    const [name] = files;
    const bytes = await readFile(join(FIREFOX_DOWNLOADS, name));
    await rm(join(FIREFOX_DOWNLOADS, name));
    return { name, bytes };
  }

  async #downloadsInChromium(action) {
    const folder = await mkdtemp(join(tmpdir(), 'download-'));
    const session = await this.page.createCDPSession();
    try {
      const rule = { behavior: 'allow', downloadPath: folder, eventsEnabled: true };
      await session.send('Browser.setDownloadBehavior', { ...rule, browserContextId: this.page.browserContext().id });
      let name = '';
      session.on('Browser.downloadWillBegin', (begin) => (name = begin.suggestedFilename));
      const done = new Promise((resolve) => {
        session.on('Browser.downloadProgress', ({ state }) => state === 'completed' && resolve(true));
      });
      await action();
      await done;
      return { name, bytes: await readFile(join(folder, name)) };
    } finally {
      await rm(folder, { recursive: true, force: true });
    }
  }

  /** Returns the colours `[red, green, blue]` of the page, which must be sharp, in a square around a point. */
  async coloursAround([x, y], pixels) {
    const side = 2 * pixels + 1;
    const clip = { x: Math.round(x) - pixels, y: Math.round(y) - pixels, width: side, height: side };
    return this.page.evaluate(coloursOf, await this.page.screenshot({ clip, encoding: 'base64' }));
  }

  /** Keeps a picture of the page, or of a part of it, in the folder that the environment variable PICTURES names, if there is one. */
  async takesAPicture(name, clip) {
    if (process.env.PICTURES) {
      await writeFile(join(process.env.PICTURES, `${name}.png`), Buffer.from(await this.page.screenshot({ clip })));
    }
  }

  /** Returns whether the browser asks before it closes the page. */
  isAskedBeforeClosing() {
    return this.page.evaluate(() => !window.dispatchEvent(new Event('beforeunload', { cancelable: true })));
  }

  /**
   * Waits until a condition holds, which may be a promise; no condition holds in a page that is being replaced. `what` describes it in the
   * message of a failure.
   */
  async until(condition, what = () => String(condition)) {
    const end = Date.now() + 1000 * PATIENCE_SECONDS;
    const holds = async () => condition();
    await this.#told(what(), async () => {
      while (!(await holds().catch(falseIfReplaced))) {
        assert.ok(Date.now() < end, `not within ${PATIENCE_SECONDS} s: ${what()}`);
        await new Promise((resolve) => setTimeout(resolve, POLL_MILLIS));
      }
    });
  }

  /** Runs an action; if it fails, the message says what the user was about to do and what the page shows. */
  async #told(what, action) {
    try {
      return await action();
    } catch (error) {
      const text = await this.text().catch(String);
      const complaints = this.complaints.join('; ') || 'nothing';
      throw new Error(`The user ${what}: ${error}\nThe page complains of: ${complaints}\nThe page shows:\n${text}`, {
        cause: error,
      });
    }
  }
}
