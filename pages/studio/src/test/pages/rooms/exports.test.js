/** A student gives a recording to others: as a table, as a log, as a page that plays it, and as a video. */
import assert from 'node:assert/strict';
import { writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { gunzipSync } from 'node:zlib';
import { slow } from '../tests.js';
import { boxOf, openReplay } from './replay-room.js';

const DRAWN = 'draw\t1.0\tAda\t1\ttext\tcyan\t1.0\t0.0\t-0.5\tball <here>';
const FILES = { 'game.notes': `${JSON.stringify({ drawn: DRAWN })}\n` };

const openRun = (t, options = {}) => openReplay(t, { files: FILES, ...options });

/** Returns a picture of the page, loaded into it. */
async function pictureOf({ page }) {
  return page.evaluateHandle(
    async (png) => {
      const image = new Image();
      image.src = `data:image/png;base64,${png}`;
      await image.decode();
      return image;
    },
    await page.screenshot({ encoding: 'base64' }),
  );
}

/** Returns the share of green pixels in a picture or video. */
function grassOf(element) {
  return element.evaluate((picture) => {
    const canvas = new OffscreenCanvas(320, 180);
    const pen = canvas.getContext('2d');
    pen.drawImage(picture, 0, 0, canvas.width, canvas.height);
    const { data } = pen.getImageData(0, 0, canvas.width, canvas.height);
    const pixels = Array.from({ length: data.length / 4 }, (_, i) => data.subarray(4 * i, 4 * i + 3));
    return pixels.filter(([red, green, blue]) => green > Math.max(red, blue) + 25).length / pixels.length;
  });
}

/** Moves a video to a moment. */
function seek(film, seconds) {
  return film.evaluate(async (video, to) => {
    video.currentTime = to;
    await new Promise((done) => video.addEventListener('seeked', done, { once: true }));
  }, seconds);
}

slow('a table has one line for each cycle of the run or of its loop', async (t) => {
  const { user } = await openRun(t);

  const { name, bytes } = await user.downloads(() => user.clicks('button', 'CSV'));

  assert.equal(name, 'game.csv');
  const lines = bytes.toString().trimEnd().split('\n');
  assert.ok(lines.length > 150 && lines.length < 250, `${lines.length} lines`);
  assert.match(lines[0], /^cycle,game_time_s,play_mode,score_left,score_right,ball_x_m,ball_y_m,ball_z_m,Ada_1_x_m,/);
  assert.ok(lines.some((line) => line.startsWith('100,')));
  await user.presses('End', 'l');
  const loop = await user.downloads(() => user.clicks('button', 'CSV'));
  assert.equal(loop.bytes.toString().trimEnd().split('\n').length, 102, 'a head and the last two seconds');
});

slow('a run is given as the log of a SimSpark server', async (t) => {
  const { user } = await openRun(t);

  const { name, bytes } = await user.downloads(() => user.clicks('button', 'Log'));

  assert.equal(name, 'game.log.gz');
  const log = gunzipSync(bytes).toString();
  ['(RSG 0 1)', '(RDS 0 1)', 'FieldLength'].forEach((part) => assert.ok(log.includes(part), part));
});

slow('a single file plays without the studio', async (t) => {
  const { user, folder } = await openRun(t, { isSharp: true });
  const { name, bytes } = await user.downloads(() => user.clicks('button', 'HTML'));
  assert.equal(name, 'game.html');
  assert.ok(bytes.length < 1_500_000, `${bytes.length} bytes`);
  await writeFile(join(folder, name), bytes);

  user.expectsComplaints(/file:/);
  await user.visits(pathToFileURL(join(folder, name)).href);

  await user.sees(/([1-9]\.\d|0\.[1-9]) of/);
  await user.sees('Ada');
  assert.deepEqual(await boxOf(user, 'canvas'), { left: 0, right: 1366, top: 0, bottom: 768 });
  const { top, bottom } = await boxOf(user, '#replay');
  assert.ok(top >= 500 && top <= 740 && bottom <= 768, `from ${top} to ${bottom}`);
  assert.ok((await grassOf(await pictureOf(user))) > 0.15);
  const line = await user.finds('slider', 'Moment of the recording');
  const { x, y, width } = await line.boundingBox();
  await user.page.mouse.click(x + 14 + (1.5 / 4.18) * (width - 28), y + 28);
  await user.sees(/1\.[45] of/);
  await user.presses('PageDown');
  await user.sees(/2\.[45] of/);
  await user.presses('PageUp');
  await user.sees('Drawings');
  await user.until(() =>
    user.page.evaluate(() => window.player.view.drawings.texts.children[0]?.name === 'ball <here>'),
  );
});

slow('a video of a section lasts as long as the section and shows the field', async (t) => {
  const { user } = await openRun(t, { isSharp: true });
  await user.presses('Home', 'l'); // the loop ends after two seconds

  const { name, bytes } = await user.downloads(() => user.clicks('button', 'Video'));

  assert.equal(name, 'game.webm');
  await user.page.goto('about:blank');
  await user.page.setContent(`<video muted src="data:video/webm;base64,${bytes.toString('base64')}"></video>`);
  const film = await user.page.$('video');
  await user.until(() => film.evaluate((video) => video.readyState >= 2));
  const [duration, ...size] = await film.evaluate((video) => [video.duration, video.videoWidth, video.videoHeight]);
  assert.ok(Math.abs(duration - 2.02) < 0.05, `${duration} s`);
  assert.deepEqual(size, [1280, 720]);
  for (const seconds of [0.02, 1.96]) {
    await seek(film, seconds);
    assert.ok((await grassOf(film)) > 0.15, `grass after ${seconds} s`);
  }
  await film.evaluate((video) => video.play());
  await user.until(() => film.evaluate((video) => video.ended));
});

slow('a video that is cancelled gives no file', async (t) => {
  const { user } = await openRun(t, {
    before: () => {
      HTMLAnchorElement.prototype.click = () => console.error('A file was given.');
    },
  });

  await user.clicks('button', 'Video');
  const progress = await user.finds('progressbar', 'Exporting');
  await user.until(() => progress.evaluate((bar) => bar.value > 0));
  await user.clicks('button', 'Cancel');

  await user.reads('alert', '', 'The export was cancelled.');
  await user.findsNo('region', 'Export progress');
  assert.equal(await user.page.$('.video-stage'), null);
});

slow('a browser without an encoder says so', async (t) => {
  const { user } = await openRun(t, {
    before: () => {
      delete window.VideoEncoder;
    },
  });

  await user.clicks('button', 'Video');

  await user.reads('alert', '', 'The export failed: this browser cannot encode videos.');
});
