/**
 * Parser and writer of S-expressions, the syntax of all messages between agents and the simulator. Pure.
 *
 * @typedef {string | any[]} Expression an atom, or a list of expressions
 */

/**
 * Parses a message; lists without a closing parenthesis extend to the end of the message.
 *
 * @param {string} text
 * @returns {Expression[]}
 */
export function readExpressions(text) {
  /** @type {Expression[]} */
  const all = [];
  const open = [all];
  for (const [token] of text.matchAll(/[()]|[^()\s]+/g)) {
    const inner = open[open.length - 1];
    if (token === '(') {
      /** @type {Expression[]} */
      const list = [];
      inner.push(list);
      open.push(list);
    } else if (token !== ')') {
      inner.push(token);
    } else if (open.length > 1) {
      open.pop();
    }
  }
  return all;
}

/** @param {Expression} expression @returns {string} the expression as sent over the wire */
export function writeExpression(expression) {
  return typeof expression === 'string' ? expression : `(${expression.map(writeExpression).join(' ')})`;
}

/**
 * @param {Expression} list
 * @param {string} name
 * @returns {Expression[] | undefined} the first nested list that begins with the name
 */
export function part(list, name) {
  return typeof list === 'string'
    ? undefined
    : /** @type {Expression[] | undefined} */ (list.find((each) => typeof each !== 'string' && each[0] === name));
}

/** @param {Expression[] | undefined} list @returns {number[]} the numbers that follow the list's name */
export function numbers(list) {
  return (list ?? []).slice(1).map(Number);
}
