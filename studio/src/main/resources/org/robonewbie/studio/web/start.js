/**
 * Lets the browser paint the page before the scripts run and the graphics are set up, which takes a while without a graphics
 * card. To wait for a frame is not enough: it is painted by the same process that then sets up the graphics, after it.
 */

const PATIENCE_MILLISECONDS = 1000;

/** A page that nobody looks at is not painted, so one does not wait for ever. */
const painted = new Promise((done) => {
  const watch = new PerformanceObserver(done);
  watch.observe({ type: 'paint', buffered: true });
  setTimeout(done, PATIENCE_MILLISECONDS);
});

await painted;
await import('./main.js');

export {};
