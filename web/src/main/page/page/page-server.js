/** The studio asks its server for files, scenes and exercises. This page has no server behind it, and answers itself. */

const NOT_HERE = 'That is not in this page yet. RoboNewbie on your computer has it.';

/** What is there, by the path behind `api/`. @type {Record<string, object>} */
const EMPTY = {
  course: { lessons: [], programs: [], standings: [] },
  scenes: { scenes: [] },
  recordings: { recordings: [] },
};

/** @param {import('./program-server.js').ProgramServer} programs */
export function answerInsteadOfServer(programs) {
  const network = window.fetch.bind(window);
  window.fetch = async (place, options) =>
    typeof place === 'string' && place.startsWith('api/')
      ? answer(place.slice('api/'.length), options ?? {}, programs)
      : network(place, options);
}

/**
 * @param {string} path
 * @param {RequestInit} options
 * @param {import('./program-server.js').ProgramServer} programs
 */
async function answer(path, options, programs) {
  if (path === 'programs' || path.startsWith('programs/')) {
    try {
      return await programs.answer(path.slice('programs/'.length), options);
    } catch (failure) {
      return new Response(/** @type {Error} */ (failure).message, { status: 500 });
    }
  }
  const content = EMPTY[path];
  return content ? Response.json(content) : new Response(NOT_HERE, { status: 404 });
}
