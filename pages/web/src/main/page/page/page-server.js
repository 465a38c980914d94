/** Answers the studio's requests in this page, because it has no server. */
import { answerBy, parametersOf, segmentsOf } from '../live/server.js';

/**
 * @typedef {import('../live/server.js').Values} Values
 * @typedef {import('../live/page-request.js').PageRequest} PageRequest
 * @typedef {(values: Record<string, any>, options: RequestInit, request: PageRequest) => Response | Promise<Response>} Part answers a request
 * @typedef {{method: string, path: string[], parameters: Record<string, string>}} ServiceRequest request to a service of the program
 */

/** @param {Record<PageRequest, Part>} parts */
export function answerInsteadOfServer(parts) {
  answerBy(async (request, values, options) => {
    try {
      return await parts[request](values, options, request);
    } catch (failure) {
      return new Response(/** @type {Error} */ (failure).message, { status: 400 });
    }
  });
}

/** @param {PageRequest} request @param {Values} values @returns {ServiceRequest} */
export function requestOf(request, values) {
  const [method] = request.split(' ');
  return { method, path: segmentsOf(request, values), parameters: parametersOf(values) };
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
