// The help: all keys from the table of actions, and what the symbols mean.
import {kActions, keyText} from './actions.js';
import {element} from './dom.js';

const kSymbols = [
  ['Left team', 'plain disc; broken lines are dashed'],
  ['Right team', 'disc with an inner ring; broken lines are dotted'],
  ['Goalie', 'light disc with a colored edge'],
  ['Nose and line', 'direction of the body, direction of the neck'],
  ['Ring around a disc', 'white: kick, pink: tackle, yellow: catch; broken: the action failed'],
  ['Stroke through a disc', 'was fouled and cannot move'],
  ['Broken outline', 'with Shift P: where the selected player estimates ball and players; red line: to where they are; dotted ring: unknown to it'],
  ['Shapes and texts', 'what the Playmaker of a player shows with the actions log and debug_client; of the selected players, or of all'],
  ['Timeline', 'circle: goal, triangle: shot, rectangle: card, tick: ball lost, red: missed decisions, diamond: a decision that cost goals; band: play modes; line below: which team has the ball'],
];

export class Help {
  /** @param {import('./viewer.js').Viewer} viewer */
  constructor(viewer) {
    this.toggle = element('input', {type: 'checkbox', onchange: () => viewer.setKeys(this.toggle.checked)});
    this.viewer = viewer;
    const groups = [...new Set(kActions.map(({group}) => group))];
    const close = element('button', {type: 'button', class: 'button text', onclick: () => this.dialog.close()}, 'Close');
    this.dialog = element('dialog', {class: 'help', 'aria-labelledby': 'help-title'},
      element('div', {class: 'help-head'}, element('h2', {id: 'help-title'}, 'Keys and symbols'), close),
      element('label', {class: 'filter'}, this.toggle, element('span', {}, 'Single keys control the page')),
      element('div', {class: 'help-groups'}, ...groups.map((group) => keyTable(group)),
        element('section', {}, element('h3', {}, 'Mouse and fingers'), facts([
          ['Click, tap', 'select a player; Shift adds'], ['Wheel, pinch', 'zoom'], ['Drag', 'move the pitch; on the timeline: seek'], ['Double click', 'zoom in, or the whole pitch'],
        ])),
        element('section', {}, element('h3', {}, 'Symbols'), facts(kSymbols))),
      element('p', {class: 'hint'}, `Written by cls ${viewer.record.header.cls ?? ''}. The page is also the log: cls convert PAGE.html game.rcg`));
  }

  open() {
    this.toggle.checked = this.viewer.settings.keys;
    this.dialog.showModal();
  }
}

function keysText(keys) {
  if (keys.length <= 2) return keys.map((key) => keyText(key));
  return [`${keyText(keys[0])} … ${keyText(keys[keys.length - 1])}`];
}

function keyTable(group) {
  const rows = kActions.filter((action) => action.group === group).map(({keys, label}) => [keysText(keys), label]);
  return element('section', {}, element('h3', {}, group), element('dl', {class: 'facts keys'},
    ...rows.map(([keys, label]) => element('div', {}, element('dt', {}, ...keys.map((key) => element('kbd', {}, key))), element('dd', {}, label)))));
}

function facts(rows) {
  return element('dl', {class: 'facts keys'}, ...rows.map(([term, text]) => element('div', {}, element('dt', {}, term), element('dd', {}, text))));
}
