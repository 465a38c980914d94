/** Advice for Java features that this page lacks. Pure functions. */

const ELSEWHERE = 'RoboNewbie on your computer supports this.';
const THREADS = `This page has no threads: let think() do a little of each behaviour, one after the other, and count cycles or compare nao.getTime() instead of waiting. ${ELSEWHERE}`;
const FILES = `Programs on this page cannot use files or the keyboard: write output with log.info(...). ${ELSEWHERE}`;
const DATES = `Time on the pitch is nao.getTime(), in seconds. Dates are not available on this page. ${ELSEWHERE}`;
const WINDOWS = `Programs on this page cannot open windows. ${ELSEWHERE}`;

/** Patterns for qualified Java names, with advice. @type {Array<[RegExp, string]>} */
const BY_NAME = [
  [/^java\.(util\.concurrent|lang\.Thread|util\.Timer|lang\.(Runtime|Process))/, THREADS],
  [/^java\.(io|nio|net)\.|^java\.util\.(Scanner|Properties|zip|jar)\b/, FILES],
  [/^java\.time\b|^java\.util\.(Date|Calendar|GregorianCalendar|TimeZone)$/, DATES],
  [/^javax\.swing|^java\.awt/, WINDOWS],
];

/** @type {Record<string, string>} */
const SIMILAR = {
  EnumMap: 'HashMap or TreeMap',
  EnumSet: 'HashSet or TreeSet',
  Hashtable: 'HashMap',
  IdentityHashMap: 'HashMap',
  WeakHashMap: 'HashMap',
  Vector: 'ArrayList',
  Stack: 'ArrayDeque with push and pop',
  BitSet: 'an array of boolean',
  StringTokenizer: 'split of String',
  StringJoiner: 'String.join',
  StringBuffer: 'StringBuilder',
  BigDecimal: 'double',
  BigInteger: 'long',
  DecimalFormat: 'String.format("%.2f", value)',
  NumberFormat: 'String.format("%.2f", value)',
  SecureRandom: 'Random',
  ThreadLocalRandom: 'Random',
};

/** Patterns for javac's messages about parts of RoboNewbie that this page lacks, with advice. @type {Array<[RegExp, string]>} */
const OF_ROBONEWBIE = [
  [
    /package org\.robonewbie\.(exercises|trial|simulator|learning)|class (Grader|Exercises|ExerciseCheck)\b/,
    `Programs on this page cannot start trials: press Check, and change the numbers between trials. ${ELSEWHERE}`,
  ],
];

/** Patterns that extract a missing name from a message of javac or the page. */
const NAMES = [
  /package ((?:[a-z]\w*\.)+[a-z]\w*) does not exist/,
  /symbol: +(?:class|variable|static) +([A-Z]\w*)[^]*location: +package ([\w.]+)/,
  /symbol: +(?:class|variable|static) +([A-Z]\w*)/,
  /package ([A-Z]\w*) does not exist/,
  /(?:provide|has no|for) (javax?\.(?:[a-z]\w*\.)*[A-Z]\w*)/,
];

/**
 * @param {string} list one line per Java package, with its name and the classes that the page lacks
 * @returns {Map<string, string>} full name by simple name
 */
export function missingClasses(list) {
  /** @type {Map<string, string>} */
  const all = new Map();
  for (const line of list.split('\n').filter(Boolean)) {
    const [home, ...names] = line.trim().split(' ');
    names.forEach((name) => all.set(name, `${home}.${name}`));
  }
  return all;
}

/**
 * @param {string} remark message of javac, or why a program cannot run here
 * @param {Map<string, string>} missing full names of missing classes, by simple names
 * @param {string} code the part of the program to which the message refers
 * @returns {string} what to do; empty if the cause is not a limitation of the page
 */
export function insteadOfMissing(remark, missing = new Map(), code = '') {
  const own = OF_ROBONEWBIE.find(([lacking]) => lacking.test(remark));
  if (own) {
    return own[1];
  }
  // For a qualified name, javac's message contains the class only if the page has other classes of its package.
  const name = [...missing.values()].find((each) => `${code}.`.startsWith(`${each}.`)) ?? fullName(remark, missing);
  return name ? advice(name) : '';
}

/** @param {string} name qualified name of a Java class or package */
function advice(name) {
  const known = BY_NAME.find(([begin]) => begin.test(name));
  if (known) {
    return known[1];
  }
  const similar = SIMILAR[name.slice(name.lastIndexOf('.') + 1)];
  return `This page does not provide ${name}${similar ? `: use ${similar} instead` : ''}. ${ELSEWHERE}`;
}

/** @param {string} remark @param {Map<string, string>} missing */
function fullName(remark, missing) {
  for (const pattern of NAMES) {
    const found = pattern.exec(remark);
    const name = found && (found[2] ? `${found[2]}.${found[1]}` : found[1]);
    if (name && /^javax?\./.test(name)) {
      return isMissing(name, missing) ? name : '';
    }
    if (name && missing.has(name)) {
      return missing.get(name);
    }
  }
  return '';
}

/**
 * Returns whether a name exists in Java but not in this page; a misspelt name is an ordinary error.
 *
 * @param {string} name
 * @param {Map<string, string>} missing
 */
function isMissing(name, missing) {
  const simple = name.slice(name.lastIndexOf('.') + 1);
  const full = [...missing.values()];
  return missing.size === 0 || missing.get(simple) === name || full.some((each) => each.startsWith(`${name}.`));
}
