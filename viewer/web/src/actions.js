// THE table of functions: each has a key, a place in the help and a function. Buttons call the same rows.
import {kLayers} from './settings.js';
import {kPlayersPerTeam} from './sides.js';

/**
 * @typedef {{id: string, group: string, label: string, keys: string[], run: (viewer: import('./viewer.js').Viewer, key: number) => void}} Action
 * `keys` as keys.js names them; `run` receives the index of the pressed one.
 */

const kDigits = ['1', '2', '3', '4', '5', '6', '7', '8', '9', '0', '-'];
const kGoals = ['goal'];
const kShots = ['goal', 'shot'];
const kCards = ['card', 'offense'];
const kMissed = ['missed'];
const kCostly = ['costly'];
const kZoomStep = 1.3;

/** @returns {Action} */
function action(group, id, label, keys, run) {
  return {id, group, label, keys, run};
}

/** @type {readonly Action[]} */
export const kActions = Object.freeze([
  action('Time', 'play', 'Play or pause', ['Space'], (viewer) => viewer.togglePlay()),
  action('Time', 'step-back', 'One cycle back', ['ArrowLeft'], (viewer) => viewer.step(-1)),
  action('Time', 'step', 'One cycle ahead', ['ArrowRight'], (viewer) => viewer.step(1)),
  action('Time', 'step-back-10', 'Ten cycles back', ['Shift+ArrowLeft'], (viewer) => viewer.step(-10)),
  action('Time', 'step-10', 'Ten cycles ahead', ['Shift+ArrowRight'], (viewer) => viewer.step(10)),
  action('Time', 'slower', 'Slower', [','], (viewer) => viewer.changeSpeed(-1)),
  action('Time', 'faster', 'Faster', ['.'], (viewer) => viewer.changeSpeed(1)),
  action('Time', 'reverse', 'Play backwards or forwards', ['Shift+R'], (viewer) => viewer.reverse()),
  action('Time', 'start', 'Start of the match', ['Home'], (viewer) => viewer.step(-Infinity)),
  action('Time', 'end', 'End of the match', ['End'], (viewer) => viewer.step(Infinity)),
  action('Time', 'live', 'Live: follow a running match', ['Shift+N'], (viewer) => viewer.follow()),

  action('Events', 'next-event', 'Next event', ['E'], (viewer) => viewer.jump(1)),
  action('Events', 'previous-event', 'Previous event', ['Shift+E'], (viewer) => viewer.jump(-1)),
  action('Events', 'next-goal', 'Next goal', ['G'], (viewer) => viewer.jump(1, kGoals)),
  action('Events', 'previous-goal', 'Previous goal', ['Shift+G'], (viewer) => viewer.jump(-1, kGoals)),
  action('Events', 'next-shot', 'Next shot or goal', ['D'], (viewer) => viewer.jump(1, kShots)),
  action('Events', 'previous-shot', 'Previous shot or goal', ['Shift+D'], (viewer) => viewer.jump(-1, kShots)),
  action('Events', 'next-card', 'Next foul, offside or card', ['Q'], (viewer) => viewer.jump(1, kCards)),
  action('Events', 'previous-card', 'Previous foul, offside or card', ['Shift+Q'], (viewer) => viewer.jump(-1, kCards)),
  action('Events', 'next-missed', 'Next missed decision', ['Shift+M'], (viewer) => viewer.jump(1, kMissed)),
  action('Events', 'next-costly', 'Next decision that cost goals', ['Shift+X'], (viewer) => viewer.jump(1, kCostly)),
  action('Events', 'highlights', 'Play the highlights', ['Y'], (viewer) => viewer.playHighlights()),

  action('Players', 'select-left', 'Player 1 to 11 of the left team', kDigits, (viewer, key) => viewer.select(key)),
  action('Players', 'select-right', 'Player 1 to 11 of the right team', kDigits.map((digit) => `Shift+${digit}`), (viewer, key) => viewer.select(kPlayersPerTeam + key)),
  action('Players', 'select-nearest', 'Nearest player to the ball', ['A'], (viewer) => viewer.selectNearest('')),
  action('Players', 'select-nearest-left', 'Nearest of the left team', ['L'], (viewer) => viewer.selectNearest('left')),
  action('Players', 'select-nearest-right', 'Nearest of the right team', ['R'], (viewer) => viewer.selectNearest('right')),
  action('Players', 'select-none', 'No player', ['U'], (viewer) => viewer.select(-1)),
  action('Players', 'decisions', 'Decisions of the selected player', ['Shift+P'], (viewer) => viewer.toggleDecisions()),

  action('View', 'zoom-in', 'Zoom in', ['Z', '+'], (viewer) => viewer.zoom(kZoomStep)),
  action('View', 'zoom-out', 'Zoom out', ['X'], (viewer) => viewer.zoom(1 / kZoomStep)),
  action('View', 'fit', 'Whole pitch', ['I'], (viewer) => viewer.fit()),
  action('View', 'follow-ball', 'Follow the ball', ['B'], (viewer) => viewer.toggleFollow('ball')),
  action('View', 'follow-player', 'Follow the selected player', ['P'], (viewer) => viewer.toggleFollow('player')),
  ...kLayers.map(({name, label, key}) => action('Show', `layer-${name}`, label, [key], (viewer) => viewer.toggleLayer(name))),

  action('Page', 'panel', 'Show or hide the side panel', ['M'], (viewer) => viewer.togglePanel()),
  action('Page', 'theme', 'Dark or light theme', ['Shift+T'], (viewer) => viewer.toggleTheme()),
  action('Page', 'describe', 'Say where the ball and the players are', ['W'], (viewer) => viewer.changed('describe')),
  action('Page', 'link', 'Copy a link to this moment', ['Shift+L'], (viewer) => viewer.changed('link')),
  action('Page', 'image', 'Save an image of this moment', ['Shift+S'], (viewer) => viewer.changed('image')),
  action('Page', 'clip', 'Record a clip: start, stop', ['Shift+C'], (viewer) => viewer.changed('clip')),
  action('Page', 'help', 'Keys and symbols', ['?'], (viewer) => viewer.changed('help')),
]);

/** @param {string} id @returns {Action} */
export function actionOf(id) {
  const found = kActions.find((each) => each.id === id);
  if (!found) throw new Error(`no action ${id}`);
  return found;
}

/** The actions by key. @returns {Map<string, {action: Action, index: number}>} */
export function actionsByKey() {
  const byKey = new Map();
  for (const each of kActions) {
    each.keys.forEach((key, index) => {
      if (byKey.has(key)) throw new Error(`key ${key} has two actions`);
      byKey.set(key, {action: each, index});
    });
  }
  return byKey;
}

/** How a key reads on a page. @param {string} key @returns {string} */
export function keyText(key) {
  return key.replace('ArrowLeft', '←').replace('ArrowRight', '→').replace('Shift+', 'Shift ');
}
