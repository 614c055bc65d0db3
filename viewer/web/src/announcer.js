// What screen readers hear: results of actions, and goals and cards while the match plays.
import {element} from './dom.js';

const kSpokenKinds = ['goal', 'card'];

export class Announcer {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.root = element('p', {class: 'unseen', role: 'status', 'aria-live': 'polite'});
    this.frame = viewer.frame;
  }

  /** @param {string} text */
  say(text) {
    this.root.textContent = text;
  }

  /** Announces the events that passed since the last call. */
  followClock() {
    const {clock, events} = this.viewer;
    const frame = clock.frame;
    if (clock.playing && frame > this.frame) {
      const passed = events.filter((event) => event.frame > this.frame && event.frame <= frame && kSpokenKinds.includes(event.kind));
      if (passed.length > 0) this.say(passed.map(({text}) => text).join('. '));
    }
    this.frame = frame;
  }
}
