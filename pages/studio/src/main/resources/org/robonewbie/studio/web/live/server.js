/**
 * Sends a request to the studio's server.
 *
 * @param {string} path path below `api/`
 * @param {RequestInit} [options]
 * @returns {Promise<Response>}
 * @throws {Error} if the request is refused; the error has the server's message and the property `status`
 */
export async function ask(path, options) {
  const answer = await fetch(`api/${path}`, options);
  if (!answer.ok) {
    throw Object.assign(new Error(await answer.text()), { status: answer.status });
  }
  return answer;
}
