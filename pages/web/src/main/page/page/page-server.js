/** The studio asks its server for files, scenes and exercises. This page has no server behind it, and answers itself. */

const NOT_HERE = 'That is not in this page yet. RoboNewbie on your computer has it.';

/**
 * @typedef {{answer: (place: string, options: RequestInit) => Promise<Response>}} Part of a server
 * @param {Record<string, Part>} parts by the first word of their places
 */
export function answerInsteadOfServer(parts) {
  const network = window.fetch.bind(window);
  window.fetch = async (place, options) =>
    typeof place === 'string' && place.startsWith('api/')
      ? answer(place.slice('api/'.length), options ?? {}, parts)
      : network(place, options);
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
