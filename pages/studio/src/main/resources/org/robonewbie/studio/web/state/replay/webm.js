/**
 * Muxes encoded pictures into a WebM file (a subset of Matroska, RFC 9559), with exact timestamps and a seek index. Pure.
 *
 * @typedef {{data: Uint8Array, milliseconds: number, isKey: boolean}} EncodedPicture
 * @typedef {{codec: 'V_VP8' | 'V_VP9', width: number, height: number, milliseconds: number}} Film
 */

const NANOSECONDS_PER_TICK = 1_000_000;
/** Maximum duration of a cluster, whose timestamps have 16 bits. */
const MAX_CLUSTER_MILLISECONDS = 30_000;
const KEY_PICTURE = 0x80;
const NAME = 'RoboNewbie';

/**
 * @param {Film} film
 * @param {readonly EncodedPicture[]} pictures pictures in order; the first one is a key frame
 * @returns {Uint8Array<ArrayBuffer>} the file
 */
export function webmOf(film, pictures) {
  const clusters = clustersOf(pictures);
  const bodies = clusters.map(clusterOf);
  const head = [infoOf(film.milliseconds), tracksOf(film)];
  const cuesLength = cuesOf(
    clusters,
    clusters.map(() => 0),
  ).length;
  let at = cuesLength + head.reduce((sum, { length }) => sum + length, 0);
  const places = bodies.map(({ length }) => {
    at += length;
    return at - length;
  });
  return joined(fileHeader(), element(0x18538067, ...head, cuesOf(clusters, places), ...bodies));
}

function fileHeader() {
  return element(
    0x1a45dfa3,
    element(0x4286, number(1)),
    element(0x42f7, number(1)),
    element(0x42f2, number(4)),
    element(0x42f3, number(8)),
    element(0x4282, letters('webm')),
    element(0x4287, number(4)),
    element(0x4285, number(2)),
  );
}

/** @param {number} milliseconds */
function infoOf(milliseconds) {
  const duration = new Uint8Array(8);
  new DataView(duration.buffer).setFloat64(0, milliseconds);
  return element(
    0x1549a966,
    element(0x2ad7b1, number(NANOSECONDS_PER_TICK)),
    element(0x4489, duration),
    element(0x4d80, letters(NAME)),
    element(0x5741, letters(NAME)),
  );
}

/** @param {Film} film */
function tracksOf({ codec, width, height }) {
  const video = element(0xe0, element(0xb0, number(width)), element(0xba, number(height)));
  const entry = [element(0xd7, number(1)), element(0x73c5, number(1)), element(0x83, number(1))];
  return element(0x1654ae6b, element(0xae, ...entry, element(0x86, letters(codec)), video));
}

/**
 * Groups pictures into clusters that begin with a key frame, so that playback can start there.
 *
 * @param {readonly EncodedPicture[]} pictures
 */
function clustersOf(pictures) {
  /** @type {EncodedPicture[][]} */
  const clusters = [];
  for (const picture of pictures) {
    const current = clusters.at(-1);
    const isLong = current && picture.milliseconds - current[0].milliseconds > MAX_CLUSTER_MILLISECONDS;
    if (!current || picture.isKey || isLong) {
      clusters.push([picture]);
    } else {
      current.push(picture);
    }
  }
  return clusters;
}

/** @param {EncodedPicture[]} pictures */
function clusterOf(pictures) {
  const start = pictures[0].milliseconds;
  const blocks = pictures.map(({ data, milliseconds, isKey }) => {
    const after = Math.round(milliseconds - start);
    const head = Uint8Array.of(0x81, after >> 8, after & 255, isKey ? KEY_PICTURE : 0);
    return element(0xa3, head, data);
  });
  return element(0x1f43b675, element(0xe7, number(Math.round(start))), ...blocks);
}

/** @param {EncodedPicture[][]} clusters @param {number[]} places offsets in the segment */
function cuesOf(clusters, places) {
  const points = clusters.map(([{ milliseconds }], i) =>
    element(
      0xbb,
      element(0xb3, number(Math.round(milliseconds), 8)),
      element(0xb7, element(0xf7, number(1)), element(0xf1, number(places[i], 8))),
    ),
  );
  return element(0x1c53bb6b, ...points);
}

/** @param {number} id ID with its length marker @param {...Uint8Array} content */
function element(id, ...content) {
  const length = content.reduce((sum, part) => sum + part.length, 0);
  const size = number(length, 8);
  size[0] = 1;
  return joined(number(id), size, ...content);
}

/**
 * @param {number} value
 * @param {number} [bytes] number of bytes; as many as needed if omitted
 * @returns {Uint8Array<ArrayBuffer>} big-endian
 */
function number(value, bytes) {
  const count = bytes ?? Math.max(1, Math.ceil(Math.log2(value + 1) / 8));
  return Uint8Array.from({ length: count }, (_, i) => Math.floor(value / 256 ** (count - 1 - i)) % 256);
}

/** @param {string} text */
function letters(text) {
  return new TextEncoder().encode(text);
}

/** @param {...Uint8Array} parts @returns {Uint8Array<ArrayBuffer>} */
function joined(...parts) {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}
