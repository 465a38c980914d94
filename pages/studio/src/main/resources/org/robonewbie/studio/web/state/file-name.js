/**
 * Checks that file names work on Windows, macOS and Linux; letters of any language are allowed. The rules are those of the Java class
 * FileName. Pure.
 */

const MAX_CHARACTERS = 80;
const RESERVED = /[/\\:*?"<>|%]/;
const CONTROL = /\p{Cc}/u;
const BLANK = /[\u00A0\u1680\u2000-\u200A\u202F\u205F]/;
const INVISIBLE = /[\u00AD\u061C\u180E\u200B\u200E\u200F\u2028-\u202E\u2060-\u206F\uFEFF\uFFF9-\uFFFB\uFFFE\uFFFF]/;
const HALF = /[\uD800-\uDBFF](?![\uDC00-\uDFFF])|(?<![\uD800-\uDBFF])[\uDC00-\uDFFF]/;
const DEVICE = /^(con|prn|aux|nul|(com|lpt)[0-9\u00b9\u00b2\u00b3]) *(\..*)?$/i;

/** @type {Array<[RegExp, (sign: string) => string]>} */
const WRONG = [
  [RESERVED, (sign) => `"${sign}"`],
  [CONTROL, (sign) => `the control character ${code(sign)}`],
  [BLANK, (sign) => `the space character ${code(sign)} instead of an ordinary space`],
  [INVISIBLE, (sign) => `the invisible character ${code(sign)}`],
  [HALF, (sign) => `the unpaired surrogate ${code(sign)}`],
];

/**
 * Normalises a name: macOS writes some letters as two characters, whereas other systems write them as one.
 *
 * @param {string} name
 * @returns {string} the normalised name
 */
export function composedName(name) {
  return name.normalize('NFC');
}

/**
 * @param {string} name without folder and extension
 * @returns {string} the problem with it, such as: contains "/"; empty if it is valid
 */
export function nameProblem(name) {
  if (name === '') {
    return 'is empty';
  }
  if (name.length > MAX_CHARACTERS) {
    return `has ${name.length} characters, more than the ${MAX_CHARACTERS} allowed`;
  }
  const wrong = WRONG.map(([signs, words]) => ({ at: name.search(signs), words }))
    .filter(({ at }) => at >= 0)
    .sort((one, other) => one.at - other.at)[0];
  if (wrong) {
    return `contains ${wrong.words(name[wrong.at])}`;
  }
  return edgeProblem(name) || (DEVICE.test(name) ? 'is the name of a device on Windows' : '');
}

/**
 * @param {string} name with its extension
 * @returns {boolean} whether Windows can store it; the rule is that of FileName.isPortable
 */
export function isPortable(name) {
  return !DEVICE.test(name) && !/[. ]$/.test(name);
}

/** @param {string} name */
function edgeProblem(name) {
  const signName = (/** @type {string} */ sign) => (sign === '.' ? 'dot' : 'space');
  if (/^[. ]/.test(name)) {
    return `begins with a ${signName(name[0])}`;
  }
  return /[. ]$/.test(name) ? `ends with a ${signName(name[name.length - 1])}` : '';
}

/** @param {string} sign */
function code(sign) {
  return `U+${sign.charCodeAt(0).toString(16).toUpperCase().padStart(4, '0')}`;
}
