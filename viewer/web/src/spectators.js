// The page for spectators of a tournament: fetches what is played now every second, the rest when it has changed, and
// changes the document only where it differs, so that open lists, the focus and the scroll position stay.

const kRefreshMs = 1000;
const kMaxPollMs = 15000;

/** Makes `target` what `source` is. Whether a list is open is the reader's choice.
 * @param {Node} target @param {Node} source */
function morph(target, source) {
  if (target.isEqualNode(source)) return;
  if (target.nodeName !== source.nodeName || !(target instanceof Element)) {
    target.replaceWith(document.importNode(source, true));
    return;
  }
  for (const {name} of [...target.attributes]) if (name !== 'open' && !source.hasAttribute(name)) target.removeAttribute(name);
  for (const {name, value} of [...source.attributes]) {
    if (name !== 'open' && target.getAttribute(name) !== value) target.setAttribute(name, value);
  }
  const children = [...target.childNodes];
  const wanted = [...source.childNodes];
  wanted.forEach((child, i) => (children[i] ? morph(children[i], child) : target.append(document.importNode(child, true))));
  children.slice(wanted.length).forEach((child) => child.remove());
}

/** Lists are found by their id: a new one comes first and moves the others. */
function openLists() {
  return new Map([...document.querySelectorAll('details')].map((list) => [list.id, list.open]));
}

/** @param {string} path @returns {Promise<Document>} */
async function fetchDocument(path) {
  const response = await fetch(path, {cache: 'no-cache'});
  if (!response.ok) throw new Error(String(response.status));
  return new DOMParser().parseFromString(await response.text(), 'text/html');
}

/** @param {Document} fetched @param {string} id */
function copyPart(fetched, id) {
  const source = fetched.getElementById(id);
  const target = document.getElementById(id);
  if (source && target) morph(target, source);
}

/** @param {Document} fetched */
function copyParts(fetched) {
  const open = openLists();
  for (const {id} of document.querySelectorAll('section.part')) if (id !== 'now') copyPart(fetched, id);
  for (const list of document.querySelectorAll('details')) {
    if (open.has(list.id)) list.open = open.get(list.id);
  }
}

let rest = document.getElementById('status').dataset.rest;

async function pollSpectators() {
  const now = await fetchDocument('now');
  const status = now.getElementById('status');
  if (rest !== status.dataset.rest) copyParts(await fetchDocument('./'));
  rest = status.dataset.rest;
  copyPart(now, 'now');
  const shown = document.getElementById('status');
  if (shown.textContent !== status.textContent) shown.textContent = status.textContent;
}

async function followTournament() {
  let pause = kRefreshMs;
  for (;;) {
    await new Promise((resolve) => setTimeout(resolve, pause));
    if (document.hidden) continue;
    try {
      await pollSpectators();
      pause = kRefreshMs;
    } catch {
      document.getElementById('status').textContent = 'No connection; trying again';
      // Readers that lost the connection together do not come back together.
      pause = Math.min(kMaxPollMs, pause * (1.5 + Math.random()));
    }
  }
}

followTournament();
