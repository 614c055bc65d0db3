// What the tab of texts and drawings says when there are none.
import {element} from './dom.js';
import {kNothingShown} from './extensions.js';

/** @returns {HTMLElement} */
export function missingDrawings() {
  return element('div', {}, element('p', {class: 'hint'}, kNothingShown),
    element('p', {class: 'hint'}, 'How a Playmaker shows them: ', element('code', {}, 'cls explain log')));
}
