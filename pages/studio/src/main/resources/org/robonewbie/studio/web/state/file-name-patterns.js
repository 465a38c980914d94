/** Patterns of file names: those of the Java classes FileName and ProgramFolder, whose test writes this file. */

export const MAX_CHARACTERS = 80;

// prettier-ignore
export const INVALID = /[/\\:*?"<>|%]|\p{Cc}|[\u00A0\u1680\u2000-\u200A\u202F\u205F]|[\u00AD\u061C\u180E\u200B\u200E\u200F\u2028-\u202E\u2060-\u206F\uFEFF\uFFF9-\uFFFB\uFFFE\uFFFF]|\p{Cs}/u;

// prettier-ignore
export const PROBLEMS = [
  { pattern: /[/\\:*?"<>|%]/iu, words: 'contains "SIGN"' },
  { pattern: /\p{Cc}/iu, words: 'contains the control character CODE' },
  { pattern: /[\u00A0\u1680\u2000-\u200A\u202F\u205F]/iu, words: 'contains the space character CODE instead of an ordinary space' },
  { pattern: /[\u00AD\u061C\u180E\u200B\u200E\u200F\u2028-\u202E\u2060-\u206F\uFEFF\uFFF9-\uFFFB\uFFFE\uFFFF]/iu, words: 'contains the invisible character CODE' },
  { pattern: /\p{Cs}/iu, words: 'contains the unpaired surrogate CODE' },
  { pattern: /^$/iu, words: 'is empty' },
  { pattern: /^\./iu, words: 'begins with a dot' },
  { pattern: /^ /iu, words: 'begins with a space' },
  { pattern: /\.$/iu, words: 'ends with a dot' },
  { pattern: / $/iu, words: 'ends with a space' },
  { pattern: /^(?:con|prn|aux|nul|(?:com|lpt)[0-9\u00B9\u00B2\u00B3]) *(?:\..*)?$/iu, words: 'is the name of a device on Windows' },
];

export const PROGRAM_PATH = /^(?:[\p{L}_][\p{L}\p{N}_-]{0,79}\/){0,12}[\p{L}_$][\p{L}\p{N}_$]{0,79}\.java$/u;
