/**
 * Decompresses a recording as far as possible: if it is still being written or was cut off, its end is missing.
 *
 * @param {Uint8Array[]} packed
 * @param {(bytes: Uint8Array) => void} take receives the pieces in order
 */
export async function unpack(packed, take) {
  const stream = new Blob(/** @type {BlobPart[]} */ (packed))
    .stream()
    .pipeThrough(new DecompressionStream('gzip'))
    .getReader();
  try {
    for (let part = await stream.read(); !part.done; part = await stream.read()) {
      take(part.value);
    }
  } catch {
    // The data before the cut is valid.
  }
}
