/**
 * Unpacks a recording as far as it goes: that of a run that goes on, or was cut off, has no end.
 *
 * @param {Uint8Array[]} packed
 * @param {(bytes: Uint8Array) => void} take gets one piece after the other
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
    // What came before the break is good.
  }
}
