// What the viewer remembers between pages: theme, layers, keys.

/**
 * @typedef {{numbers: boolean, stamina: boolean, view: boolean, kick: boolean, tackle: boolean, catch: boolean, offside: boolean,
 *   trails: boolean, allTrails: boolean, types: boolean, drawings: boolean, focus: boolean, pointing: boolean}} Layers
 */

/** Layers in the order of the menu: name, label, whether they are on at first. */
export const kLayers = Object.freeze([
  {name: 'numbers', label: 'Numbers', key: 'N', on: true},
  {name: 'stamina', label: 'Stamina rings', key: 'S', on: false},
  {name: 'view', label: 'View cones', key: 'V', on: false},
  {name: 'kick', label: 'Kickable areas', key: 'K', on: false},
  {name: 'tackle', label: 'Tackle areas', key: 'T', on: false},
  {name: 'catch', label: 'Catch areas', key: 'C', on: false},
  {name: 'offside', label: 'Offside lines', key: 'O', on: false},
  {name: 'trails', label: 'Trails of ball and selected players', key: 'F', on: true},
  {name: 'allTrails', label: 'Trails of all players', key: 'Shift+F', on: false},
  {name: 'types', label: 'Player types', key: 'H', on: false},
  {name: 'drawings', label: 'Drawings of Playmakers', key: 'Shift+A', on: true},
  {name: 'focus', label: 'Focus points', key: 'J', on: false},
  {name: 'pointing', label: 'Pointing arms', key: 'Shift+J', on: false},
]);

const kStorageKey = 'cls-viewer';

/** Storage may be forbidden, for example in pages from disk. */
function stored() {
  try {
    return JSON.parse(window.localStorage.getItem(kStorageKey) ?? '{}') ?? {};
  } catch {
    return {};
  }
}

export class Settings {
  /** @param {{reducedMotion?: boolean, saved?: any}} [options] */
  constructor({reducedMotion = false, saved = stored()} = {}) {
    /** @type {'auto' | 'dark' | 'light'} */
    this.theme = ['dark', 'light'].includes(saved.theme) ? saved.theme : 'auto';
    this.keys = saved.keys !== false;
    this.panel = saved.panel !== false;
    this.layers = /** @type {Layers} */ ({});
    for (const {name, on} of kLayers) {
      const moves = name === 'trails' || name === 'allTrails';
      this.layers[name] = typeof saved.layers?.[name] === 'boolean' ? saved.layers[name] : on && !(moves && reducedMotion);
    }
  }

  save() {
    try {
      window.localStorage.setItem(kStorageKey, JSON.stringify({theme: this.theme, keys: this.keys, panel: this.panel, layers: this.layers}));
    } catch {
      // The settings then last as long as the page.
    }
  }
}
