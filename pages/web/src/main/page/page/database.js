/** Promises for the browser's IndexedDB. */

/** @template T @param {IDBRequest<T>} request @returns {Promise<T>} */
export const result = (request) =>
  new Promise((done, fail) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => fail(request.error);
  });

/** @param {IDBTransaction} transaction @returns {Promise<void>} resolves when the transaction has committed */
export const ended = (transaction) =>
  new Promise((done, fail) => {
    transaction.oncomplete = () => done();
    transaction.onabort = () => fail(transaction.error ?? new Error('The browser aborted the transaction.'));
  });

/**
 * @param {string} name
 * @param {(database: IDBDatabase) => void} create creates the object stores of a new database
 * @returns {Promise<IDBDatabase>}
 */
export async function openDatabase(name, create) {
  const request = indexedDB.open(name, 1);
  request.onupgradeneeded = () => create(request.result);
  return result(request);
}
