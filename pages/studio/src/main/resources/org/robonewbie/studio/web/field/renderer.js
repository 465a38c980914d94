/** Renderers of the 3D views. */
import * as THREE from 'three';
import { CanvasRenderer } from './canvas-renderer.js';

/**
 * Creates a renderer with an opaque canvas, which halves the work of the browser's compositor. Without WebGL it draws on a 2D canvas.
 *
 * @returns {THREE.WebGLRenderer}
 */
export function opaqueRenderer() {
  const canvas = document.createElement('canvas');
  const context = canvas.getContext('webgl2', { alpha: false, antialias: true, powerPreference: 'high-performance' });
  return context ? new THREE.WebGLRenderer({ canvas, context }) : /** @type {any} */ (new CanvasRenderer());
}

/** @param {THREE.WebGLRenderer} renderer @returns {boolean} whether it uses WebGL, not a 2D canvas */
export function isWebGl(renderer) {
  return renderer instanceof THREE.WebGLRenderer;
}

/** @param {THREE.WebGLRenderer} renderer @returns {string} the browser's description of the graphics hardware */
export function graphicsOf(renderer) {
  if (!isWebGl(renderer)) {
    return 'software';
  }
  const gl = renderer.getContext();
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  return info ? String(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : '';
}
