/** A small fictitious world for the tests of pure state. */

/** @returns {any} two teams, one robot with two links and a hinge between them */
export function sampleScene() {
  return {
    kind: 'scene',
    revision: 3,
    field: { length: 12, width: 8 },
    teams: { left: 'Blue', right: '' },
    robots: [{ id: 1, team: 'Blue', side: 'left', number: 2, type: 'ARM' }],
    models: { ARM: sampleModel() },
    playModes: ['BeforeKickOff', 'KickOff_Left', 'KickOff_Right', 'PlayOn'],
  };
}

/** @returns {any} a torso with a forward arm on a hinge at its right side, 0.1 m forward */
export function sampleModel() {
  return {
    links: [
      { name: 'body', position: [0, 0, 0], size: [0.1, 0.1, 0.2] },
      { name: 'arm', position: [0.1, 0.1, 0], size: [0.02, 0.2, 0.02] },
    ],
    hinges: [
      { joint: 'ARM', child: 1, parent: 0, anchor: [0.1, 0, 0], axis: [1, 0, 0], minDegrees: -90, maxDegrees: 90 },
    ],
  };
}

/**
 * @param {object} [changes]
 * @returns {any}
 */
export function sampleFrame(changes = {}) {
  return {
    paused: false,
    sceneRevision: 3,
    cycle: 100,
    gameTime: 2,
    speed: 1,
    realTimeFactor: 1,
    playMode: 0,
    scoreLeft: 1,
    scoreRight: 0,
    half: 1,
    ball: Float32Array.of(0, 0, 0.042, 1, 0, 0, 0),
    robots: [{ torso: Float32Array.of(0, 0, 0.4, 1, 0, 0, 0), degrees: Float32Array.of(0) }],
    ...changes,
  };
}

/**
 * @param {ArrayLike<number>} actual
 * @param {ArrayLike<number>} expected
 * @param {number} tolerance
 */
export function isNear(actual, expected, tolerance = 1e-5) {
  return (
    actual.length === expected.length &&
    Array.from(actual).every((value, i) => Math.abs(value - expected[i]) <= tolerance)
  );
}
