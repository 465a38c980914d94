/**
 * Cross-sections of the NAO's shells from one end of a limb to the other, in the frame of its link (z up, metres). `nao-design.js` builds
 * the bodies from them.
 *
 * @typedef {import('./loft.js').Section} Section
 */

/** @type {Section[]} */
export const TORSO = [
  { at: -0.098, wide: 0.03, deep: 0.026 },
  { at: -0.092, wide: 0.046, deep: 0.04 },
  { at: -0.06, wide: 0.053, deep: 0.048 },
  { at: -0.015, wide: 0.057, deep: 0.053, y: 0.002 },
  { at: 0.035, wide: 0.066, deep: 0.058, y: 0.004 },
  { at: 0.07, wide: 0.07, deep: 0.054, y: 0.002 },
  { at: 0.092, wide: 0.056, deep: 0.044 },
  { at: 0.1, wide: 0.03, deep: 0.028 },
  { at: 0.101, wide: 0, deep: 0 },
];

/** @type {Section[]} */
export const HEAD = [
  { at: -0.046, wide: 0, deep: 0 },
  { at: -0.044, wide: 0.028, deep: 0.026, y: 0.004 },
  { at: -0.03, wide: 0.052, deep: 0.05, y: 0.006 },
  { at: -0.005, wide: 0.065, deep: 0.06, y: 0.004 },
  { at: 0.022, wide: 0.067, deep: 0.062 },
  { at: 0.046, wide: 0.057, deep: 0.055, y: -0.003 },
  { at: 0.062, wide: 0.033, deep: 0.034, y: -0.006 },
  { at: 0.066, wide: 0, deep: 0, y: -0.006 },
];

/** @type {Section[]} */
export const UPPER_ARM = [
  { at: -0.036, wide: 0, deep: 0, x: -0.006 },
  { at: -0.032, wide: 0.018, deep: 0.018, x: -0.006 },
  { at: -0.018, wide: 0.029, deep: 0.029, x: -0.005 },
  { at: 0.01, wide: 0.031, deep: 0.03, x: -0.004 },
  { at: 0.034, wide: 0.026, deep: 0.026, x: -0.008, y: -0.005 },
  { at: 0.046, wide: 0.021, deep: 0.021, x: -0.01, y: -0.008 },
  { at: 0.05, wide: 0.012, deep: 0.012, x: -0.01, y: -0.009 },
  { at: 0.05, wide: 0, deep: 0, x: -0.01, y: -0.009 },
];

/** @type {Section[]} */
export const FOREARM = [
  { at: -0.046, wide: 0, deep: 0 },
  { at: -0.046, wide: 0.012, deep: 0.012 },
  { at: -0.038, wide: 0.022, deep: 0.022 },
  { at: -0.012, wide: 0.028, deep: 0.029 },
  { at: 0.012, wide: 0.027, deep: 0.027 },
  { at: 0.03, wide: 0.021, deep: 0.021 },
  { at: 0.034, wide: 0.014, deep: 0.014 },
  { at: 0.034, wide: 0, deep: 0 },
];

/** @type {Section[]} */
export const HAND = [
  { at: 0.032, wide: 0.012, deep: 0.012 },
  { at: 0.04, wide: 0.017, deep: 0.021 },
  { at: 0.055, wide: 0.016, deep: 0.022 },
  { at: 0.063, wide: 0.01, deep: 0.016 },
  { at: 0.064, wide: 0, deep: 0 },
];

/** @type {Section[]} */
export const THIGH = [
  { at: -0.078, wide: 0, deep: 0, y: -0.004 },
  { at: -0.078, wide: 0.02, deep: 0.02, y: -0.004 },
  { at: -0.07, wide: 0.028, deep: 0.03, y: -0.003 },
  { at: -0.04, wide: 0.035, deep: 0.037 },
  { at: 0.0, wide: 0.038, deep: 0.041, y: 0.002 },
  { at: 0.032, wide: 0.036, deep: 0.036, y: -0.004 },
  { at: 0.048, wide: 0.026, deep: 0.026, y: -0.008 },
  { at: 0.055, wide: 0.01, deep: 0.01, y: -0.01 },
  { at: 0.056, wide: 0, deep: 0, y: -0.01 },
];

/** @type {Section[]} */
export const SHANK = [
  { at: -0.052, wide: 0, deep: 0, y: -0.006 },
  { at: -0.052, wide: 0.022, deep: 0.022, y: -0.006 },
  { at: -0.044, wide: 0.029, deep: 0.029, y: -0.005 },
  { at: -0.01, wide: 0.036, deep: 0.037, y: 0.002 },
  { at: 0.022, wide: 0.037, deep: 0.039, y: 0.003 },
  { at: 0.044, wide: 0.031, deep: 0.031, y: 0.002 },
  { at: 0.054, wide: 0.02, deep: 0.02 },
  { at: 0.055, wide: 0, deep: 0 },
];

/** @type {Section[]} */
export const FOOT = [
  { at: -0.0065, wide: 0.044, deep: 0.083 },
  { at: -0.001, wide: 0.0445, deep: 0.083 },
  { at: 0.009, wide: 0.042, deep: 0.079, y: -0.001 },
  { at: 0.019, wide: 0.037, deep: 0.066, y: -0.01 },
  { at: 0.029, wide: 0.031, deep: 0.047, y: -0.022 },
  { at: 0.036, wide: 0.024, deep: 0.032, y: -0.029 },
  { at: 0.037, wide: 0, deep: 0, y: -0.029 },
];

/** @type {Section[]} */
export const SOLE = [
  { at: -0.01, wide: 0, deep: 0 },
  { at: -0.01, wide: 0.038, deep: 0.077 },
  { at: -0.009, wide: 0.0445, deep: 0.0835 },
  { at: -0.005, wide: 0.0455, deep: 0.0845 },
];
