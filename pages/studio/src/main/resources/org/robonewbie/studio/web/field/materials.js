/** Materials for robots, and team colours. */
import * as THREE from 'three';

/** Team colours that colour-blind viewers can distinguish (after Okabe and Ito). */
export const TEAM_COLOURS = { left: 0x0a6fd8, right: 0xf07f13, '': 0x8b949e };

/**
 * Creates a material for geometries with the attributes `color` and `paint`, in the colour of the robot's team.
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
      .replace('#include <common>', '#include <common>\nattribute vec2 paint;\nvarying float glow;')
      .replace(
        '#include <color_vertex>',
        '#include <color_vertex>\nvColor.rgb = mix(vColor.rgb, robotPaint().rgb, paint.x);\nglow = paint.y;',
      );
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying float glow;')
      .replace(
        '#include <emissivemap_fragment>',
        '#include <emissivemap_fragment>\ntotalEmissiveRadiance += diffuseColor.rgb * glow;',
      );
  };
  return material;
}

/**
 * Creates the material of a transparent shell in the colour of the robot's team.
 *
 * @returns {THREE.Material}
 */
export function ghostMaterial() {
  const material = new THREE.MeshLambertMaterial({
    transparent: true,
    opacity: 0.22,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: 3,
    polygonOffsetUnits: 12,
  });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nvarying vec3 teamColour;')
      .replace('#include <begin_vertex>', '#include <begin_vertex>\nteamColour = robotPaint().rgb;');
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying vec3 teamColour;')
      .replace('#include <color_fragment>', 'diffuseColor.rgb = teamColour;');
  };
  return material;
}

/**
 * Creates the material of the number plates: a texture of twelve cells, 0 (empty) to 11, selected by the robot's number.
 *
 * @returns {THREE.Material}
 */
export function numberMaterial() {
  const material = new THREE.MeshLambertMaterial({ map: numberPicture(), transparent: true, depthWrite: false });
  material.onBeforeCompile = (shader) => {
    shader.vertexShader = shader.vertexShader.replace(
      '#include <uv_vertex>',
      '#include <uv_vertex>\nvMapUv.x = (vMapUv.x + robotPaint().a) / 12.0;',
    );
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
