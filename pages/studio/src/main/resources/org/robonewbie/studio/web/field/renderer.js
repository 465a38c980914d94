/** WebGL renderers of the 3D views. */
import * as THREE from 'three';

/**
 * Creates a renderer with an opaque canvas, which halves the work of the browser's compositor.
 *
 * @param {boolean} antialias
 * @returns {THREE.WebGLRenderer}
 */
export function opaqueRenderer(antialias) {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2', { alpha: false, antialias, powerPreference: 'high-performance' });
  return new THREE.WebGLRenderer({ canvas, antialias, ...(context && { context }) });
}
