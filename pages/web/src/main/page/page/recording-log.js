/** Converts recordings to SimSpark logs in a separate worker. */

/** @param {Blob} recording recording file @returns {Promise<ArrayBuffer>} the log, gzip-compressed */
export async function simSparkLog(recording) {
  const packed = new Int8Array(await recording.arrayBuffer());
  const worker = new Worker('world-worker.js', { type: 'module', name: 'programs' });
  try {
    const log = await new Promise((done, fail) => {
      worker.onmessage = ({ data }) => ('result' in data ? done(data.result) : fail(new Error(data.failure)));
      worker.onerror = (event) => fail(new Error(event.message));
      worker.postMessage({ call: { id: 0, name: 'simSparkLog', args: [packed] } });
    });
    const stream = new Blob([log]).stream().pipeThrough(new CompressionStream('gzip'));
    return await new Response(stream).arrayBuffer();
  } finally {
    worker.terminate();
  }
}
