/** Name tags above the robots. They are page elements and not rendered by WebGL, so they stay sharp at every quality level. */
import * as THREE from 'three';
import { element } from '../panels/elements.js';
import { figureOf } from '../state/figure.js';
import { nameOf, shownTags } from '../state/name-tags.js';

const place = new THREE.Vector3();

export class NameTags {
  #isOn = true;
  /** @type {import('../state/figure.js').Figure[]} */
  #figures = [];
  /** @type {HTMLElement[]} */
  #tags = [];
  /** @type {Array<{width: number, height: number}>} */
  #sizes = [];

  /** @param {HTMLElement} stage container of the picture */
  constructor(stage) {
    this.box = element('div', { class: 'name-tags', 'aria-hidden': 'true' });
    stage.append(this.box);
  }

  /** @param {import('../live/state-frame.js').Scene} scene scene with the robots */
  setScene({ robots, models }) {
    this.#figures = robots.map(({ type }) => figureOf(models[type]));
    this.#tags = robots.map((player) => {
      const tag = element('span', { class: 'name-tag', 'data-side': player.side }, nameOf(player));
      tag.style.visibility = 'hidden';
      return tag;
    });
    this.#sizes = [];
    this.box.replaceChildren(...this.#tags);
  }

  get isOn() {
    return this.#isOn;
  }

  /** @param {boolean} on whether name tags are shown */
  set isOn(on) {
    this.#isOn = on;
    this.box.hidden = !on;
  }

  /**
   * Positions all name tags above their robots.
   *
   * @param {readonly Float32Array[]} poses poses of all links of each robot
   * @param {THREE.PerspectiveCamera} camera
   * @param {{width: number, height: number, slope: number}} picture its size in pixels, and the tangent of half its vertical angle of view
   */
  draw(poses, camera, { width, height, slope }) {
    if (!this.#isOn || this.#tags.length === 0 || poses.length !== this.#tags.length) {
      return;
    }
    if (this.#sizes.length === 0 || this.#sizes[0].width === 0) {
      this.#sizes = this.#tags.map((tag) => ({ width: tag.offsetWidth, height: tag.offsetHeight }));
    }
    const tags = poses.map(([x, y, z], i) => {
      const metres = Math.hypot(x - camera.position.x, y - camera.position.y, z - camera.position.z);
      const { aboveTorso, height: robotMetres } = this.#figures[i];
      const at = place.set(x, y, z + aboveTorso).project(camera);
      const robotPixels = at.z < 1 && z !== 0 ? (robotMetres * height) / (2 * slope * metres) : 0;
      return { x: ((at.x + 1) / 2) * width, y: ((1 - at.y) / 2) * height, metres, robotPixels, ...this.#sizes[i] };
    });
    const shown = shownTags(tags);
    this.#tags.forEach((tag, i) => moveTo(tag, tags[i], shown[i]));
  }
}

/** @param {HTMLElement} tag @param {import('../state/name-tags.js').Tag} to @param {boolean} isShown */
function moveTo(tag, { x, y, width, height }, isShown) {
  const visibility = isShown ? 'visible' : 'hidden';
  if (tag.style.visibility !== visibility) {
    tag.style.visibility = visibility;
  }
  const transform = `translate(${Math.round(x - width / 2)}px, ${Math.round(y - height)}px)`;
  if (isShown && tag.style.transform !== transform) {
    tag.style.transform = transform;
  }
}
