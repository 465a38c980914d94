/** Compresses bytes with gzip; the counterpart of `replay/unpack.js`. */

/** @param {Uint8Array<ArrayBuffer>} bytes */
export async function pack(bytes) {
  const packed = new Blob([bytes]).stream().pipeThrough(new CompressionStream('gzip'));
  return new Uint8Array(await new Response(packed).arrayBuffer());
}
