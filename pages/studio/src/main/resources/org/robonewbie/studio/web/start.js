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

/** @param {Error} error @returns {never} */
function sayWhatIsMissing(error) {
  const place = document.getElementById('stage-opening');
  if (place) {
    place.textContent = 'The page has not arrived whole. Is the program still running? Then load the page again.';
  }
  throw error;
}

await painted;
await import('./main.js').catch(sayWhatIsMissing);

export {};
