/** Handles the studio's requests for files, scenes and exercises locally, because this page has no server. */

const NOT_HERE = 'This is not available on this page. Use RoboNewbie on your computer.';

/**
 * @typedef {{answer: (place: string, options: RequestInit) => Promise<Response>}} Part request handler for one part of the API
 * @param {Record<string, Part>} parts handlers by the first segment of their path
 */
export function answerInsteadOfServer(parts) {
  const network = window.fetch.bind(window);
  window.fetch = async (place, options) =>
    typeof place === 'string' && place.startsWith('api/')
      ? answer(place.slice('api/'.length), options ?? {}, parts)
      : network(place, options);
}

/**
 * @typedef {{method: string, path: string[], parameters: Record<string, string>}} ServiceRequest request to a service of the program
 * @param {string} place
 * @param {RequestInit} options
 * @returns {ServiceRequest}
 */
export function requestOf(place, { method = 'GET' }) {
  const [path, search] = place.split('?');
  return {
    method,
    path: path.split('/').filter(Boolean).map(decodeURIComponent),
    parameters: Object.fromEntries(new URLSearchParams(search)),
  };
}

/** @param {string} result JSON, or why a service rejected the request */
export const isAnswer = (result) => /^["{]/.test(result);

/** @param {string} result JSON, or why a service rejected the request @returns {Response} */
export function responseOf(result) {
  if (!isAnswer(result)) {
    throw new Error(result);
  }
  return new Response(result);
}

/**
 * @param {string} place
 * @param {RequestInit} options
 * @param {Record<string, Part>} parts
 */
async function answer(place, options, parts) {
  const [word] = place.split(/[/?]/);
  const part = parts[word];
  if (part) {
    try {
      return await part.answer(place.slice(word.length), options);
    } catch (failure) {
      return new Response(/** @type {Error} */ (failure).message, { status: 400 });
    }
  }
  return new Response(NOT_HERE, { status: 404 });
}
