// Elements. Text from the log only ever becomes text: there is no other way to fill an element here.

/** @param {string} tag
 * @param {Record<string, any>} [properties] attributes; functions become listeners, `on...`
 * @param {...(Node | string | number)} children @returns {any} */
export function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (typeof value === 'function') made.addEventListener(name.slice(2), value);
    else if (value === true) made.setAttribute(name, '');
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(name, String(value));
  }
  made.append(
    ...children.map((child) => (child instanceof Node ? child : document.createTextNode(String(child)))),
  );
  return made;
}

/** Sets the text of an element if it changed. @param {Element} target @param {string} text */
export function setText(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

/** Sets an attribute if it changed. @param {Element} target @param {string} name @param {string} value */
export function setAttribute(target, name, value) {
  if (target.getAttribute(name) !== value) target.setAttribute(name, value);
}
