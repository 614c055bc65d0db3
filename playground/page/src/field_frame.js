// The frame with the replay viewer: a new one for each match.
import { element } from '../../../viewer/web/src/dom.js';

export class FieldFrame {
  /** @param {HTMLElement} place of the frame */
  constructor(place) {
    this.place = place;
    this.frame = null;
    this.waiting = null;
    window.addEventListener('message', ({ source, data }) => {
      if (!this.frame || source !== this.frame.contentWindow || data.kind !== 'ready') return;
      for (const message of this.waiting ?? []) this.#post(message);
      this.waiting = null;
    });
  }

  /** An empty viewer. @param {string} title */
  open(title) {
    this.waiting = [];
    this.frame = element('iframe', { src: 'field.html', title, class: 'field-frame' });
    this.place.replaceChildren(this.frame);
  }

  /** More of the stream of the match. @param {Uint8Array} bytes */
  push(bytes) {
    this.#send({ kind: 'stream', bytes });
  }

  /** @param {Uint8Array[]} decisions of the left and the right side */
  addDecisions(decisions) {
    this.#send({ kind: 'decisions', decisions });
  }

  /** There will not be any. @param {string} why one sentence without a period */
  endWithoutDecisions(why) {
    this.#send({ kind: 'decisions', why });
  }

  /** The match has ended before its first picture, or not. */
  fail() {
    this.#send({ kind: 'failed' });
  }

  #send(message) {
    if (this.waiting) this.waiting.push(message);
    else this.#post(message);
  }

  #post(message) {
    this.frame.contentWindow.postMessage(message, '*');
  }
}
