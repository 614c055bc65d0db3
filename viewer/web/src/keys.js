// Keys of the page. Single letters can be switched off in the help (WCAG 2.1.4).
import {actionsByKey} from './actions.js';

/** "G", "Shift+7", "Space", "?": the name of a key event as actions.js writes it; '' if it is none of the page's.
 * @param {{key: string, code: string, shiftKey: boolean, ctrlKey: boolean, altKey: boolean, metaKey: boolean}} event */
export function keyName(event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return '';
  const shift = event.shiftKey ? 'Shift+' : '';
  if (event.key === ' ') return 'Space';
  const digit = /^(?:Digit|Numpad)([0-9])$/.exec(event.code);
  if (digit) return shift + digit[1];
  if (event.code === 'Minus' || event.key === '-') return `${shift}-`;
  if (/^[a-z]$/i.test(event.key)) return shift + event.key.toUpperCase();
  if (/^(Arrow(Left|Right)|Home|End)$/.test(event.key)) return shift + event.key;
  return event.key;
}

/** True for elements that need a key for themselves. @param {any} target @param {string} name of the key */
export function needsKey(target, name) {
  if (!(target instanceof Element)) return false;
  const tag = target.tagName;
  if (tag === 'INPUT') return target.getAttribute('type') !== 'checkbox' || name === 'Space';
  if (tag === 'SELECT' || tag === 'TEXTAREA') return true;
  if (tag === 'BUTTON' || tag === 'SUMMARY' || tag === 'A') {
    if (name === 'Space') return true;
    return target.getAttribute('role') === 'tab' && /Arrow|Home|End/.test(name);
  }
  return target.getAttribute('tabindex') === '0' && target.getAttribute('role') === 'region' && /Home|End/.test(name);
}

/** @param {import('./viewer.js').Viewer} viewer @param {() => boolean} blocked true while a dialog is open */
export function listenToKeys(viewer, blocked) {
  const byKey = actionsByKey();
  document.addEventListener('keydown', (event) => {
    const name = keyName(event);
    const found = byKey.get(name);
    if (!found || blocked() || event.defaultPrevented || needsKey(event.target, name)) return;
    const single = /^(Shift\+)?[A-Z0-9,.+?-]$/.test(name);
    if (single && !viewer.settings.keys) return;
    event.preventDefault();
    found.action.run(viewer, found.index);
  });
}
