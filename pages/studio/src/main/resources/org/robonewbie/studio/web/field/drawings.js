/** The robots' drawings on the ground, rendered as one mesh for all shapes and one sprite per label. */
import * as THREE from 'three';
import { isDrawable, onGround, raised, trianglesOf } from '../state/drawing-shapes.js';

/**
 * @typedef {import('../state/drawing-shapes.js').Stand} Stand
 * @typedef {{stand: Stand, drawing: import('../state/robot/telemetry.js').Drawing}} Placed
 */

/** Height above the ground in metres: above pitch lines and soft shadows. */
const HEIGHT = 0.012;

/** Text height as a fraction of the picture's height. */
const TEXT_SCALE = 0.021;
const FONT_PIXELS = 44;
const MAX_TEXTS = 300;
const CODE = /^#([0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})$/i;

/** A mesh for all shapes, and a group of sprites for the labels. */
export class DrawingGroup {
  /** @param {string} name @param {THREE.MeshBasicMaterialParameters} look */
  constructor(name, look) {
    const material = new THREE.MeshBasicMaterial({
      vertexColors: true,
      side: THREE.DoubleSide,
      toneMapped: false,
      ...look,
    });
    this.shapes = new THREE.Mesh(new THREE.BufferGeometry(), material);
    this.shapes.frustumCulled = false;
    this.texts = new THREE.Group();
    this.group = new THREE.Group();
    this.group.name = name;
    this.group.add(this.shapes, this.texts);
  }

  /** @param {number[]} places x, y and z of each vertex @param {number[]} colours @param {3 | 4} channels number per colour */
  fill(places, colours, channels) {
    this.shapes.geometry.dispose();
    this.shapes.geometry = new THREE.BufferGeometry();
    this.shapes.geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
    this.shapes.geometry.setAttribute('color', new THREE.Float32BufferAttribute(colours, channels));
    this.shapes.visible = places.length > 0;
  }

  /** Adds a label. @param {THREE.SpriteMaterial} look @param {string} text */
  addText(look, text) {
    const sprite = new THREE.Sprite(look);
    sprite.center.set(0.5, 0);
    sprite.scale.set(TEXT_SCALE * look.userData.aspect, TEXT_SCALE, 1);
    sprite.name = text;
    this.texts.add(sprite);
    return sprite;
  }
}

export class FieldDrawings extends DrawingGroup {
  /** Materials of the labels, by colour and text. @type {Map<string, THREE.SpriteMaterial>} */
  #looks = new Map();

  constructor() {
    super('drawings', {});
    this.show([]);
  }

  /** @param {Placed[]} placed all visible drawings */
  show(placed) {
    const drawable = placed.filter(({ drawing }) => isDrawable(drawing));
    if (drawable.length === 0 && !this.group.visible) {
      return;
    }
    this.group.visible = drawable.length > 0;
    this.#fill(drawable);
    this.#write(drawable.filter(({ drawing }) => drawing.shape === 'text').slice(0, MAX_TEXTS));
  }

  /** @param {Placed[]} placed */
  #fill(placed) {
    const [places, colours] = [/** @type {number[]} */ ([]), /** @type {number[]} */ ([])];
    for (const { stand, drawing } of placed) {
      const corners = trianglesOf(stand, drawing);
      const paint = new THREE.Color(knownColour(drawing.colour)).toArray();
      places.push(...raised(corners, HEIGHT));
      corners.filter((_, i) => i % 2 === 0).forEach(() => colours.push(...paint));
    }
    this.fill(places, colours, 3);
  }

  /** @param {Placed[]} placed labels */
  #write(placed) {
    const before = this.#looks;
    this.#looks = new Map();
    this.texts.clear();
    for (const { stand, drawing } of placed) {
      const key = `${drawing.colour}\n${drawing.text}`;
      const look = this.#looks.get(key) ?? before.get(key) ?? textLook(drawing.text, knownColour(drawing.colour));
      this.#looks.set(key, look);
      before.delete(key);
      const [x, y] = onGround(stand, drawing.place);
      const sprite = this.addText(look, drawing.text);
      sprite.position.set(x, y, HEIGHT);
      sprite.renderOrder = 2;
    }
    for (const gone of before.values()) {
      gone.map?.dispose();
      gone.dispose();
    }
  }
}

/** @param {string} colour colour specified by an agent @returns {string} a colour that can be drawn */
function knownColour(colour) {
  if (CODE.test(colour)) {
    return colour.slice(0, colour.length < 6 ? 4 : 7);
  }
  const name = colour.toLowerCase();
  return name in THREE.Color.NAMES ? name : 'magenta';
}

/**
 * Creates a material for text with a dark outline, which is legible on both grass and lines.
 *
 * @param {string} text @param {string} colour
 */
export function textLook(text, colour) {
  const canvas = document.createElement('canvas');
  const pen = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const font = `600 ${FONT_PIXELS}px system-ui, sans-serif`;
  pen.font = font;
  canvas.width = Math.min(2048, Math.ceil(pen.measureText(text).width) + 16);
  canvas.height = FONT_PIXELS + 16;
  Object.assign(pen, { font, textBaseline: 'middle', lineJoin: 'round', lineWidth: 8, fillStyle: colour });
  pen.strokeStyle = 'rgb(0 0 0 / 65%)';
  pen.strokeText(text, 8, canvas.height / 2, 2032);
  pen.fillText(text, 8, canvas.height / 2, 2032);
  const map = new THREE.CanvasTexture(canvas);
  map.colorSpace = THREE.SRGBColorSpace;
  const look = new THREE.SpriteMaterial({ map, sizeAttenuation: false, depthTest: false, toneMapped: false });
  look.userData.aspect = canvas.width / canvas.height;
  return look;
}
