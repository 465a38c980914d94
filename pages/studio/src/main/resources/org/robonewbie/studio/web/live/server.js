/** Requests to the studio's server, or to what answers in its place. */
import { pathPart } from '../state/path-part.js';

/**
 * @typedef {import('./page-request.js').PageRequest} PageRequest
 * @typedef {Record<string, string | number>} Values names for the words in capital letters of a request, and parameters
 * @typedef {(request: PageRequest, values: Values, options: RequestInit) => Promise<Response>} Service
 */

const NAMES = new Set(['KIND', 'NAME', 'PATH']);

/** @type {Service} */
let service = fetched;

/**
 * @param {PageRequest} request
 * @param {Values} [values]
 * @param {RequestInit} [options] body and headers
 * @returns {Promise<Response>}
 * @throws {Error} if the request is refused; the error has the server's message and the property `status`
 */
export async function ask(request, values = {}, options = {}) {
  const response = await service(request, values, options);
  if (!response.ok) {
    throw Object.assign(new Error(await response.text()), { status: response.status });
  }
  return response;
}

/**
 * @param {PageRequest} request
 * @param {Values} [values]
 * @param {RequestInit} [options]
 * @returns {Promise<any>} the JSON of the answer to {@link ask}
 */
export async function answer(request, values, options) {
  return (await ask(request, values, options)).json();
}

/** @param {Service} other answers all requests of this page from now on */
export function answerBy(other) {
  service = other;
}

/** @param {PageRequest} request @param {Values} values @returns {string[]} the segments of the path, with names */
export function segmentsOf(request, values) {
  const [, path] = request.split(' ');
  return path.split('/').flatMap((word) => {
    const text = NAMES.has(word) ? String(values[word]) : word;
    return word === 'PATH' ? text.split('/') : [text];
  });
}

/** @param {Values} values @returns {Record<string, string>} the parameters among them */
export function parametersOf(values) {
  const entries = Object.entries(values).filter(([name]) => !NAMES.has(name));
  return Object.fromEntries(entries.map(([name, value]) => [name, String(value)]));
}

/** @type {Service} */
function fetched(request, values, options) {
  const [method] = request.split(' ');
  const path = segmentsOf(request, values).map(pathPart).join('/');
  const search = String(new URLSearchParams(parametersOf(values)));
  return fetch(`api/${path}${search && `?${search}`}`, { ...options, method });
}
