// The choices of a decision that was played again as a table: mean goals, and a dot for each playout.
import {element} from './dom.js';
import {signed} from './layer_choices.js';

const kDotsWidth = 120;
const kDotsHeight = 14;
const kSvgNames = 'http://www.w3.org/2000/svg';

/** @param {import('./replayed.js').Replayed} replayed @returns {HTMLElement} */
export function choicesTable(replayed) {
  const rows = replayed.choices.map((choice, index) => element('tr', {class: index === replayed.best ? 'best' : ''},
    element('th', {scope: 'row'}, index === 0 ? `${choice.text} (played)` : choice.text),
    element('td', {class: 'number'}, signed(choice.mean)), element('td', {}, dots(choice))));
  return element('table', {class: 'choices'},
    element('caption', {}, `Goals after each choice, ${replayed.choices[0].worths.length} playouts; difference ${replayed.cost.toFixed(2)} (95 %: ${replayed.low.toFixed(2)} to ${replayed.high.toFixed(2)})`),
    element('thead', {}, element('tr', {}, element('th', {}, 'choice'), element('th', {class: 'number'}, 'mean'), element('th', {}, '\u22121 to 1'))),
    element('tbody', {}, ...rows));
}

/** From a goal against at the left to a goal at the right. */
function dots({worths, mean}) {
  const picture = svg('svg', {width: kDotsWidth, height: kDotsHeight, viewBox: `0 0 ${kDotsWidth} ${kDotsHeight}`, role: 'img', 'aria-label': `${worths.length} playouts, mean ${signed(mean)}`});
  const x = (worth) => 4 + ((Math.min(1, Math.max(-1, worth)) + 1) / 2) * (kDotsWidth - 8);
  picture.append(svg('line', {x1: x(0), x2: x(0), y1: 0, y2: kDotsHeight, class: 'zero'}));
  for (const worth of worths) picture.append(svg('circle', {cx: x(worth), cy: kDotsHeight / 2, r: 3, class: 'playout'}));
  picture.append(svg('line', {x1: x(mean), x2: x(mean), y1: 1, y2: kDotsHeight - 1, class: 'mean'}));
  return picture;
}

function svg(name, attributes) {
  const node = document.createElementNS(kSvgNames, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, String(value));
  return node;
}
