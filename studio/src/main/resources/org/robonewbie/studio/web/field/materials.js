/** The surfaces of robots and the colours of teams. */
import * as THREE from 'three';

/** Colours that also people with colour-blindness tell apart (after Okabe and Ito). */
export const TEAM_COLOURS = { left: 0x0a6fd8, right: 0xf07f13, '': 0x8b949e };

/**
 * A surface for bodies with the attributes `color` and `paint`, and `teamColour` for each robot.
 *
 * @param {boolean} glossy
 * @returns {THREE.Material}
 */
export function robotMaterial(glossy) {
  const material = glossy
    ? new THREE.MeshStandardMaterial({ vertexColors: true, roughness: 0.42, metalness: 0, envMapIntensity: 0.55 })
    : new THREE.MeshLambertMaterial({ vertexColors: true });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace(
        '#include <common>',
        `#include <common>
        attribute vec2 paint;
        attribute vec3 teamColour;
        varying vec2 vPaint;
        varying vec3 vTeamColour;`,
      )
      .replace(
        '#include <begin_vertex>',
        `#include <begin_vertex>
        vPaint = paint;
        vTeamColour = teamColour;`,
      );
    shader.fragmentShader = shader.fragmentShader
      .replace(
        '#include <common>',
        `#include <common>
        varying vec2 vPaint;
        varying vec3 vTeamColour;`,
      )
      .replace(
        '#include <color_fragment>',
        `#include <color_fragment>
        diffuseColor.rgb = mix(diffuseColor.rgb, vTeamColour, vPaint.x);`,
      )
      .replace(
        '#include <emissivemap_fragment>',
        `#include <emissivemap_fragment>
        totalEmissiveRadiance += diffuseColor.rgb * vPaint.y;`,
      );
  };
  return material;
}

/**
 * The number plates: twelve cells in one picture, 0 (empty) to 11; the attribute `cell` chooses.
 *
 * @returns {THREE.Material}
 */
export function numberMaterial() {
  const material = new THREE.MeshLambertMaterial({ map: numberPicture(), transparent: true, depthWrite: false });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nattribute float cell;')
      .replace('#include <uv_vertex>', '#include <uv_vertex>\nvMapUv.x = (vMapUv.x + cell) / 12.0;');
  };
  return material;
}

function numberPicture() {
  const size = 128;
  const canvas = document.createElement('canvas');
  canvas.width = 12 * size;
  canvas.height = size;
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  pen.font = `800 ${0.86 * size}px system-ui, "Segoe UI", Roboto, "DejaVu Sans", sans-serif`;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.fillStyle = '#1b2430';
  for (let number = 1; number <= 11; number++) {
    pen.fillText(String(number), (number + 0.5) * size, 0.54 * size, 0.94 * size);
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.anisotropy = 4;
  return texture;
}
