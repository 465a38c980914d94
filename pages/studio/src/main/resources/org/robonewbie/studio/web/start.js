/**
 * Lets the browser paint the page before the scripts run and set up WebGL, which is slow without a graphics card. Waiting for an animation
 * frame is not enough, because the same process paints the page and sets up WebGL.
 */

const TIMEOUT_MILLISECONDS = 1000;

/** A hidden page is not painted, so the wait has a timeout. */
const painted = new Promise((done) => {
  const watch = new PerformanceObserver(done);
  watch.observe({ type: 'paint', buffered: true });
  setTimeout(done, TIMEOUT_MILLISECONDS);
});

/** @param {Error} error @returns {never} */
function showLoadError(error) {
  const place = document.getElementById('stage-opening');
  if (place) {
    place.textContent = 'The page did not load completely. If the program is still running, reload the page.';
  }
  throw error;
}

await painted;
await import('./main.js').catch(showLoadError);

export {};
