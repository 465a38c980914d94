/** Creates a self-contained HTML file that plays a recording, with all scripts, styles and the recording embedded. */

const SCRIPT = /^(import|export)([^'"]*?from\s*|\s*)(['"])(\.{1,2}\/[^'"]+|three)\3/gm;
const START = 'replay/player.js';
const STYLES = ['theme.css', 'layout.css', 'field.css', 'replay.css', 'drawings.css'];

/** The page has no toolbar, so the picture takes the whole height. */
const WHOLE_PAGE = 'body { grid-template-rows: minmax(0, 1fr); }';

/**
 * @param {object} run
 * @param {Uint8Array} run.packed the recording without commands, gzip-compressed
 * @param {string} run.name
 * @param {string[]} run.pictures telemetry lines with drawings
 * @param {Record<string, import('../state/kinematics.js').RobotModel>} models
 * @returns {Promise<string>}
 */
export async function standalonePage({ packed, name, pictures }, models) {
  /** @type {Map<string, string>} */
  const scripts = new Map();
  await collect(START, scripts);
  const three = await Promise.all(
    ['three.core.min.js', 'three.module.min.js'].map((file) => text(`vendor/three/${file}`)),
  );
  const imports = Object.fromEntries([
    ...[...scripts].map(([path, source]) => [`studio/${path}`, dataAddress(source)]),
    ['three-core', dataAddress(three[0])],
    ['three', dataAddress(three[1].replaceAll('./three.core.min.js', 'three-core'))],
  ]);
  const styles = (await Promise.all(STYLES.map(text))).join('\n');
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>${name.replaceAll(/[<&]/g, '')} · RoboNewbie</title>
<style>${styles}
${WHOLE_PAGE}</style>
<script type="importmap">${JSON.stringify({ imports })}</script></head>
<body><main id="field-room"><div id="stage"></div><section id="score-board" class="panel centred"></section><section id="drawings" class="panel" hidden></section><section id="replay" class="panel"></section></main>
<script type="application/json" id="models">${JSON.stringify(models)}</script>
<script type="application/json" id="pictures">${JSON.stringify(pictures).replaceAll('<', '\\u003c')}</script>
<script type="text/plain" id="recording">${base64(packed)}</script>
<script type="module">import 'studio/${START}';</script></body></html>`;
}

/** @param {string} path @param {Map<string, string>} scripts */
async function collect(path, scripts) {
  if (scripts.has(path)) {
    return;
  }
  scripts.set(path, '');
  const source = await text(path);
  /** @type {string[]} */
  const needed = [];
  const changed = source.replaceAll(SCRIPT, (_, word, names, quote, target) => {
    if (target === 'three') {
      return `${word}${names}${quote}three${quote}`;
    }
    const resolved = new URL(target, `http://here/${path}`).pathname.slice(1);
    needed.push(resolved);
    return `${word}${names}${quote}studio/${resolved}${quote}`;
  });
  scripts.set(path, changed);
  for (const each of needed) {
    await collect(each, scripts);
  }
}

/** @param {string} path */
async function text(path) {
  return (await fetch(path)).text();
}

/** @param {string} source */
function dataAddress(source) {
  return `data:text/javascript;base64,${base64(new TextEncoder().encode(source))}`;
}

/** @param {Uint8Array} bytes */
function base64(bytes) {
  let letters = '';
  for (let at = 0; at < bytes.length; at += 0x8000) {
    letters += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
  }
  return btoa(letters);
}
