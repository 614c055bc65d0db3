// Buttons below the field. Every action of the table has one here, in a menu, in the panel or on the field.
import {actionOf, keyText} from './actions.js';
import {element, setAttribute, setText} from './dom.js';
import {icon} from './icons.js';
import {kLayers} from './settings.js';

/** A button that runs an action. @param {import('./viewer.js').Viewer} viewer @param {string} id
 * @param {string | null} iconName @param {string} [className] @param {string} [text] instead of an icon */
export function actionButton(viewer, id, iconName, className = '', text = '') {
  const {label, keys, run} = actionOf(id);
  const title = `${label} (${keyText(keys[0])})`;
  const content = iconName ? icon(/** @type {any} */ (iconName)) : text;
  return element('button', {type: 'button', class: `button ${className}`, 'aria-label': label, title, 'data-action': id, onclick: () => run(viewer, 0)}, content);
}

const kMenuWidth = 330;
const kMenuMargin = 8;

/** Puts the body of a menu where the window has room: over its button, or below it. @param {HTMLElement} menu */
function placeMenu(menu) {
  const [summary, body] = /** @type {HTMLElement[]} */ ([...menu.children]);
  const button = summary.getBoundingClientRect();
  const {clientWidth, clientHeight} = document.documentElement;
  const width = Math.min(kMenuWidth, clientWidth - 2 * kMenuMargin);
  const above = button.top - 2 * kMenuMargin;
  const below = clientHeight - button.bottom - 2 * kMenuMargin;
  const room = Math.max(above, below);
  body.style.width = `${width}px`;
  body.style.maxHeight = `${Math.max(0, room)}px`;
  body.style.left = `${Math.min(Math.max(kMenuMargin, button.right - width), clientWidth - width - kMenuMargin)}px`;
  const height = body.offsetHeight;
  body.style.top = `${above >= Math.min(height, below) ? button.top - kMenuMargin - height : button.bottom + kMenuMargin}px`;
}

export class Controls {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.viewer = viewer;
    this.play = actionButton(viewer, 'play', 'play', 'primary');
    this.reverse = actionButton(viewer, 'reverse', 'reverse');
    this.highlights = actionButton(viewer, 'highlights', 'star');
    this.speed = element('output', {class: 'speed', 'aria-label': 'Speed'});
    this.follow = actionButton(viewer, 'follow-ball', 'follow');
    this.panel = actionButton(viewer, 'panel', 'panel');
    this.clip = actionButton(viewer, 'clip', 'clip');
    this.live = actionButton(viewer, 'live', null, 'live', 'LIVE');
    this.layers = this.#layerMenu();
    const more = (ids) => ids.map(([id, name]) => actionButton(viewer, id, name));
    this.root = element('div', {class: 'controls', role: 'toolbar', 'aria-label': 'Controls'},
      element('div', {class: 'group'}, ...more([['previous-event', 'previous'], ['step-back', 'stepBack']]), this.play, ...more([['step', 'stepForward'], ['next-event', 'next']]), this.live),
      element('div', {class: 'group'}, actionButton(viewer, 'slower', null, 'narrow', '−'), this.speed, actionButton(viewer, 'faster', null, 'narrow', '+'), this.reverse),
      element('div', {class: 'group'}, actionButton(viewer, 'next-goal', 'goal'), this.highlights),
      element('div', {class: 'group end'}, ...more([['zoom-out', 'zoomOut'], ['zoom-in', 'zoomIn'], ['fit', 'fit']]), this.follow),
      element('div', {class: 'group'}, this.layers, this.panel, ...more([['theme', 'theme'], ['image', 'image']]), this.clip, ...more([['link', 'link'], ['help', 'help']])));
  }

  #layerMenu() {
    const {viewer} = this;
    this.boxes = kLayers.map(({name, label, key}) => {
      const box = element('input', {type: 'checkbox', onchange: () => viewer.toggleLayer(name)});
      return {name, box, row: element('label', {class: 'menu-row'}, box, element('span', {}, label), element('kbd', {}, keyText(key)))};
    });
    const menu = element('details', {class: 'menu'},
      element('summary', {class: 'button', 'aria-label': 'What to show on the field', title: 'What to show on the field'}, icon('layers')),
      element('div', {class: 'menu-body'}, ...this.boxes.map(({row}) => row)));
    const place = () => menu.open && placeMenu(menu);
    // The event 'toggle' comes later: for a frame the menu would be where the last one was.
    menu.firstElementChild.addEventListener('click', (event) => {
      event.preventDefault();
      menu.open = !menu.open;
      place();
    });
    window.addEventListener('resize', place);
    window.addEventListener('scroll', place, {passive: true});
    menu.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      menu.open = false;
      menu.querySelector('summary').focus();
    });
    document.addEventListener('pointerdown', (event) => {
      if (event.target instanceof Node && !menu.contains(event.target)) menu.open = false;
    });
    return menu;
  }

  show() {
    const {clock, camera, settings} = this.viewer;
    if (this.shownPlaying !== clock.playing) {
      this.shownPlaying = clock.playing;
      this.play.replaceChildren(icon(clock.playing ? 'pause' : 'play'));
      setAttribute(this.play, 'aria-label', clock.playing ? 'Pause' : 'Play');
    }
    setText(this.speed, `${clock.backwards ? '−' : ''}${clock.speed}×`);
    this.live.hidden = !clock.live;
    setAttribute(this.live, 'aria-pressed', String(clock.following));
    setAttribute(this.reverse, 'aria-pressed', String(clock.backwards));
    setAttribute(this.highlights, 'aria-pressed', String(clock.segments.length > 0));
    setAttribute(this.follow, 'aria-pressed', String(camera.follow === 'ball'));
    setAttribute(this.clip, 'aria-pressed', String(this.viewer.recording));
    setAttribute(this.panel, 'aria-pressed', String(settings.panel));
    for (const {name, box} of this.boxes) box.checked = settings.layers[name];
  }
}
