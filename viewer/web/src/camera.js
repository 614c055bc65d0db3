// The view of the pitch: meters to pixels.
import {clamp} from './geometry.js';

const kMarginX = 5.2;
const kMarginY = 3.6;
const kMaxZoom = 16;

export class Camera {
  /** @param {{length: number, width: number}} pitch in meters */
  constructor(pitch) {
    this.pitch = pitch;
    this.width = 1;
    this.height = 1;
    this.zoom = 1;
    this.x = 0;
    this.y = 0;
    /** @type {'' | 'ball' | 'player'} */
    this.follow = '';
    /** Pixels (of CSS) per meter. */
    this.scale = 1;
    this.#setScale();
  }

  /** At zoom 1 the whole pitch with its goals is visible. */
  #setScale() {
    const {length, width} = this.pitch;
    this.scale = this.zoom * Math.min(this.width / (length + 2 * kMarginX), this.height / (width + 2 * kMarginY));
  }

  resize(width, height) {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.#setScale();
    this.#limit();
  }

  screenX(x) {
    return this.width / 2 + (x - this.x) * this.scale;
  }

  screenY(y) {
    return this.height / 2 + (y - this.y) * this.scale;
  }

  fieldX(x) {
    return (x - this.width / 2) / this.scale + this.x;
  }

  fieldY(y) {
    return (y - this.height / 2) / this.scale + this.y;
  }

  /** Zooms by a factor; the point of the pitch below (x, y), in pixels, stays where it is. */
  zoomBy(factor, x = this.width / 2, y = this.height / 2) {
    const fieldX = this.fieldX(x);
    const fieldY = this.fieldY(y);
    this.zoom = clamp(this.zoom * factor, 1, kMaxZoom);
    this.#setScale();
    if (this.follow === '') {
      this.x += fieldX - this.fieldX(x);
      this.y += fieldY - this.fieldY(y);
    }
    this.#limit();
  }

  /** Moves the pitch by pixels, as a finger does. */
  panBy(dx, dy) {
    this.follow = '';
    this.x -= dx / this.scale;
    this.y -= dy / this.scale;
    this.#limit();
  }

  /** Puts a point of the pitch in the middle. */
  center(x, y) {
    this.x = x;
    this.y = y;
    this.#limit();
  }

  /** Shows the whole pitch. */
  fit() {
    this.zoom = 1;
    this.x = 0;
    this.y = 0;
    this.follow = '';
    this.#setScale();
  }

  /** Keeps the pitch in the picture. */
  #limit() {
    const freeX = Math.max(0, this.pitch.length / 2 + kMarginX - this.width / 2 / this.scale);
    const freeY = Math.max(0, this.pitch.width / 2 + kMarginY - this.height / 2 / this.scale);
    this.x = clamp(this.x, -freeX, freeX);
    this.y = clamp(this.y, -freeY, freeY);
  }
}
