/**
 * Pose table for the graphics card: a texture with one row per robot. In a row, each limb's matrix takes three texels (its upper rows), and
 * the last texel holds the team colour and the number. All robots therefore need only one draw call; without a graphics card this is three
 * times as fast as one call per kind of limb.
 */
import * as THREE from 'three';

const POINTS_PER_LIMB = 3;

/** Shader code that reads robot and limb data. */
const READ_TABLE = `
attribute float limb;
attribute float robot;
uniform highp sampler2D robotTable;
vec4 robotPaint() {
  return texelFetch(robotTable, ivec2(textureSize(robotTable, 0).x - 1, int(robot)), 0);
}
mat4 limbPose() {
  ivec2 at = ivec2(${POINTS_PER_LIMB} * int(limb), int(robot));
  return transpose(mat4(
    texelFetch(robotTable, at, 0),
    texelFetch(robotTable, at + ivec2(1, 0), 0),
    texelFetch(robotTable, at + ivec2(2, 0), 0),
    vec4(0.0, 0.0, 0.0, 1.0)));
}`;

/** Rotates the normal with its limb; the division compensates for non-uniform scale. */
const POSE_NORMAL = `
mat4 pose = limbPose();
mat3 turned = mat3(pose);
objectNormal = turned * (objectNormal / max(vec3(dot(turned[0], turned[0]), dot(turned[1], turned[1]), dot(turned[2], turned[2])), 1e-9));`;

export class RobotTable {
  constructor() {
    /** Shared by all materials, so that replacing the table updates them all. */
    this.uniform = { value: /** @type {THREE.DataTexture | null} */ (null) };
    this.values = new Float32Array();
    this.width = 0;
  }

  /**
   * Replaces the table with an empty one; limbs that are never set are invisible.
   *
   * @param {number} robots
   * @param {number} limbs
   */
  clear(robots, limbs) {
    this.dispose();
    this.width = POINTS_PER_LIMB * limbs + 1;
    this.values = new Float32Array(4 * this.width * robots);
    this.uniform.value = new THREE.DataTexture(this.values, this.width, robots, THREE.RGBAFormat, THREE.FloatType);
  }

  /**
   * @param {number} robot
   * @param {number} limb
   * @param {THREE.Matrix4} matrix
   */
  setPose(robot, limb, matrix) {
    const { elements } = matrix;
    let at = 4 * (this.width * robot + POINTS_PER_LIMB * limb);
    for (let row = 0; row < POINTS_PER_LIMB; row++) {
      for (let column = 0; column < 4; column++) {
        this.values[at++] = elements[4 * column + row];
      }
    }
  }

  /**
   * @param {number} robot
   * @param {THREE.Color} colour
   * @param {number} number
   */
  setPaint(robot, colour, number) {
    this.values.set([colour.r, colour.g, colour.b, number], 4 * (this.width * (robot + 1) - 1));
  }

  /** @param {number} robot @returns {{poses: THREE.Matrix4[], team: number[]}} the poses of its limbs and its team colour */
  robot(robot) {
    const row = this.values.subarray(4 * this.width * robot, 4 * this.width * (robot + 1));
    const poses = Array.from({ length: (this.width - 1) / POINTS_PER_LIMB }, (_, limb) => {
      const [a, b, c, d, e, f, g, h, i, j, k, l] = row.subarray(4 * POINTS_PER_LIMB * limb);
      return new THREE.Matrix4(a, b, c, d, e, f, g, h, i, j, k, l, 0, 0, 0, 1);
    });
    return { poses, team: [...row.slice(-4, -1)] };
  }

  /** Uploads the table to the graphics card before the next picture. */
  send() {
    if (this.uniform.value) {
      this.uniform.value.needsUpdate = true;
    }
  }

  dispose() {
    this.uniform.value?.dispose();
    this.uniform.value = null;
  }

  /**
   * Makes a material move each vertex with its limb.
   *
   * @template {THREE.Material} M
   * @param {M} material
   * @returns {M} the same material
   */
  posed(material) {
    const paint = material.onBeforeCompile;
    const isLit = !(material instanceof THREE.MeshDepthMaterial);
    material.onBeforeCompile = (shader, renderer) => {
      paint.call(material, shader, renderer);
      shader.uniforms.robotTable = this.uniform;
      shader.vertexShader = shader.vertexShader
        .replace('#include <common>', `#include <common>${READ_TABLE}`)
        .replace('#include <beginnormal_vertex>', `#include <beginnormal_vertex>${isLit ? POSE_NORMAL : ''}`)
        .replace(
          '#include <begin_vertex>',
          `#include <begin_vertex>\ntransformed = (${isLit ? 'pose' : 'limbPose()'} * vec4(transformed, 1.0)).xyz;`,
        );
    };
    material.customProgramCacheKey = () => `posed ${paint}`;
    return material;
  }
}
