/** 3D view of the field: creates and renders the three.js scene; the caller supplies the content. */
import * as THREE from 'three';
import { BALL_RADIUS, ballRadiusOf } from '../state/ball-radius.js';
import { ball, ballShape } from './ball.js';
import { BallTrail } from './ball-trail.js';
import { Board } from './board.js';
import { FieldDrawings } from './drawings.js';
import { Goals } from './goals.js';
import { Light, PALETTES, roomReflections } from './light.js';
import { NameTags } from './name-tags.js';
import { pitch } from './pitch.js';
import { hazeMetres } from './flat-material.js';
import { graphicsOf, isWebGl, opaqueRenderer } from './renderer.js';
import { Ring } from './ring.js';
import { InstancedRobots } from './instanced-robots.js';
import { SoftShadows } from './soft-shadows.js';
import { Things } from './things.js';

/**
 * @typedef {import('../live/state-frame.js').Scene} Scene
 * @typedef {import('../state/smoothing.js').Picture} Picture
 * @typedef {import('../state/quality.js').Quality} Quality
 */

/** Minimum size of the ball: a distant ball is enlarged so that it stays visible. */
const MIN_BALL_PIXELS = 4;

/** Pixel ratio of a still picture: 2 × 2 samples per page pixel smooth all edges. */
const STILL_PIXEL_RATIO = 2;
const STILL_MILLISECONDS = 300;

/** Minimum free fraction of the picture. Panels that leave less are treated as overlays and ignored. */
const MIN_FREE_PART = 0.45;

export class FieldView {
  /**
   * @param {HTMLElement} stage container of the picture
   * @param {Quality} quality
   */
  constructor(stage, quality) {
    this.stage = stage;
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(38, 1, 0.05, 160);
    this.camera.up.set(0, 0, 1);
    this.light = new Light(this.scene);
    this.robots = new InstancedRobots();
    this.softShadows = new SoftShadows();
    this.drawings = new FieldDrawings();
    this.things = new Things();
    this.goals = new Goals();
    this.ball = ball();
    this.ball.visible = false;
    this.trail = new BallTrail();
    this.ring = new Ring();
    this.names = new NameTags(stage);
    this.scene.add(this.robots.group, this.softShadows.group, this.drawings.group, this.things.group, this.ball);
    this.board = new Board();
    this.scene.add(this.goals.group, this.trail.dots, this.ring.group, this.board.group);
    this.palette = PALETTES.light;
    /** Whether the user has switched real shadows on or off; if undefined, they depend on the quality level. @type {boolean | undefined} */
    this.wantedShadows = undefined;
    /** @type {Scene | undefined} */
    this.content = undefined;
    /** @type {THREE.Group | undefined} */
    this.pitch = undefined;
    this.quality = quality;
    /** Whether the last picture was rendered at full resolution. */
    this.isFine = false;
    this.lastDrawn = Infinity;
    /** Margins covered by panels, in page pixels. */
    this.covered = { left: 0, top: 0, right: 0, bottom: 0 };
    this.renderer = opaqueRenderer();
    this.renderer.info.autoReset = false;
    this.renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    stage.append(this.renderer.domElement);
    this.setQuality(quality);
  }

  /** @returns {string} the browser's description of the graphics hardware */
  get graphics() {
    return graphicsOf(this.renderer);
  }

  /** Whether the sun can cast shadows. */
  get canShade() {
    return isWebGl(this.renderer);
  }

  /** @param {Quality} quality */
  setQuality(quality) {
    this.quality = quality;
    this.scene.environment = quality.glossy ? roomReflections(this.renderer) : null;
    this.scene.environmentIntensity = 0.5;
    this.robots.setQuality(quality);
    this.ball.geometry.dispose();
    this.ball.geometry = ballShape(quality.nearDetail === 'fine' ? 'fine' : quality.farDetail);
    if (this.content) {
      this.#layPitch(this.content);
    }
    this.#drawShadows();
    this.resize();
  }

  /** @param {boolean} wanted whether the sun casts shadows at every quality level; otherwise soft spots are drawn */
  setShadows(wanted) {
    this.wantedShadows = wanted;
    this.#drawShadows();
  }

  /** Whether the sun casts shadows. */
  get realShadows() {
    return this.canShade && (this.wantedShadows ?? this.quality.shadows);
  }

  #drawShadows() {
    const real = this.realShadows;
    this.renderer.shadowMap.enabled = real;
    this.light.sun.castShadow = real;
    this.softShadows.group.visible = !real;
    const sheet = this.scene.getObjectByName('shadow-sheet');
    if (sheet) {
      sheet.visible = real;
    }
    this.robots.setShadows(real);
    this.things.setShadows(real);
    this.goals.setShadows(real);
    this.scene.traverse((thing) => {
      const material = /** @type {THREE.Mesh} */ (thing).material;
      if (material instanceof THREE.Material) {
        material.needsUpdate = true;
      }
    });
  }

  /** @param {'light' | 'dark'} theme */
  setTheme(theme) {
    this.palette = PALETTES[theme];
    this.light.setPalette(this.palette);
    if (this.content) {
      this.#layPitch(this.content);
    }
  }

  /** @param {Scene} content teams, robots and field */
  setScene(content) {
    const groundOf = (/** @type {Scene | undefined} */ scene) => JSON.stringify([scene?.field, scene?.details]);
    if (groundOf(content) !== groundOf(this.content)) {
      this.goals.setField(content.field);
      this.#layPitch(content);
    }
    this.content = content;
    this.robots.setScene(content);
    this.softShadows.setScene(content);
    this.names.setScene(content);
    this.things.setThings(content.things ?? []);
    this.things.setShadows(this.realShadows);
    this.ball.visible = false;
  }

  /** @param {Scene} content */
  #layPitch(content) {
    if (this.pitch) {
      this.scene.remove(this.pitch);
    }
    this.scene.fog = new THREE.Fog(this.palette.sky, ...hazeMetres(content.field));
    this.pitch = pitch(content, this.palette, this.quality.glossy);
    this.scene.add(this.pitch);
    this.#drawShadows();
  }

  /** Fits the picture to the page and redraws it immediately, because a resized canvas is black until it is drawn. */
  resize() {
    if (this.#fit() && 'drawn' in this.stage.dataset) {
      this.#render();
    }
  }

  /** @returns {boolean} whether the number of pixels has changed */
  #fit() {
    const { width, height } = this.#size();
    const { left, top, right, bottom } = this.#margins(width, height);
    const pixelRatio = Math.min(window.devicePixelRatio, this.quality.pixelRatio);
    const before = this.renderer.getSize(new THREE.Vector2());
    this.isFine = false;
    this.camera.setViewOffset(width, height, (right - left) / 2, (bottom - top) / 2, width, height);
    if (before.x === width && before.y === height && this.renderer.getPixelRatio() === pixelRatio) {
      return false;
    }
    this.renderer.setPixelRatio(pixelRatio);
    this.renderer.setSize(width, height);
    return true;
  }

  #size() {
    return { width: Math.max(1, this.stage.clientWidth), height: Math.max(1, this.stage.clientHeight) };
  }

  /** @param {number} width @param {number} height */
  #margins(width, height) {
    const { left, top, right, bottom } = this.covered;
    const [across, up] = [left + right < (1 - MIN_FREE_PART) * width, top + bottom < (1 - MIN_FREE_PART) * height];
    return { left: across ? left : 0, right: across ? right : 0, top: up ? top : 0, bottom: up ? bottom : 0 };
  }

  /** @param {{left: number, top: number, right: number, bottom: number}} covered page pixels covered by panels */
  setCovered(covered) {
    this.covered = covered;
    this.resize();
  }

  /** @returns {import('../state/view-point.js').FreeView} */
  get free() {
    const { width, height } = this.#size();
    const { left, top, right, bottom } = this.#margins(width, height);
    const perPixel = this.#slope / height;
    return { across: perPixel * (width - left - right), up: perPixel * (height - top - bottom) };
  }

  /** Tangent of half the vertical angle of view. */
  get #slope() {
    return Math.tan(THREE.MathUtils.degToRad(this.camera.fov / 2));
  }

  /**
   * Updates the poses of all objects.
   *
   * @param {Picture} picture
   */
  update(picture) {
    this.robots.update(picture.robots, this.camera.position);
    this.softShadows.update(this.robots.poses, picture.ball);
    this.things.update(picture.things ?? []);
    const [x, y, z, rw, rx, ry, rz] = picture.ball;
    this.ball.position.set(x, y, z);
    this.ball.quaternion.set(rx, ry, rz, rw);
    this.ball.visible = true;
  }

  /**
   * Moves the camera, and adapts the light and the goals to its view.
   *
   * @param {import('./camera-controller.js').CameraController} cameraController
   * @param {number} seconds since the last call
   * @returns {boolean} whether the picture is still changing
   */
  look(cameraController, seconds) {
    const moves = cameraController.update(this.robots.poses, seconds, this.ball.position.toArray());
    this.light.shine(cameraController.shown.target, this.camera.position);
    return this.goals.fade(cameraController.viewOfRobot, seconds) || moves;
  }

  draw() {
    if (this.isFine) {
      this.#fit();
    }
    this.lastDrawn = performance.now();
    this.#render();
  }

  /** Redraws a still picture at full resolution, which is slow. @param {number} now milliseconds */
  refine(now) {
    if (!this.isFine && now - this.lastDrawn > STILL_MILLISECONDS && !document.hidden) {
      this.isFine = true;
      this.renderer.setPixelRatio(Math.max(window.devicePixelRatio, STILL_PIXEL_RATIO));
      this.#render();
    }
  }

  /** Returns the size of a page pixel at a point in the scene, in metres. @param {THREE.Vector3} place */
  metresPerPixel(place) {
    return (2 * this.#slope * this.camera.position.distanceTo(place)) / this.#size().height;
  }

  #render() {
    const minDiameter = MIN_BALL_PIXELS * this.metresPerPixel(this.ball.position);
    this.ball.scale.setScalar(Math.max(ballRadiusOf(this.content), minDiameter / 2) / BALL_RADIUS);
    this.board.follow(this.robots.poses, this.content?.robots ?? []);
    this.trail.setPixelRatio(this.renderer.getPixelRatio());
    this.camera.updateMatrixWorld();
    this.names.draw(this.robots.poses, this.camera, { ...this.#size(), slope: this.#slope });
    this.renderer.info.reset();
    this.renderer.render(this.scene, this.camera);
    this.stage.dataset.drawn = '';
  }

  /** Number of draw calls for the last picture, including shadows. */
  get drawCalls() {
    return this.renderer.info.render.calls;
  }

  /**
   * Returns the ray through a point on the page.
   *
   * @param {number} clientX
   * @param {number} clientY
   * @returns {THREE.Ray}
   */
  rayAt(clientX, clientY) {
    return rayAt(this, clientX, clientY);
  }
}

/** @param {{stage: HTMLElement, camera: THREE.Camera}} view @param {number} clientX @param {number} clientY */
export function rayAt({ stage, camera }, clientX, clientY) {
  const box = stage.getBoundingClientRect();
  const place = new THREE.Vector2(
    (2 * (clientX - box.left)) / box.width - 1,
    1 - (2 * (clientY - box.top)) / box.height,
  );
  const caster = new THREE.Raycaster();
  caster.setFromCamera(place, camera);
  return caster.ray;
}
