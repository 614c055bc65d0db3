// The page of a tournament while it is played: fetches itself again and copies what changed. Nothing moves under the
// mouse: cells change in place, rows keep their order until the reader sorts them.

const kListPollMs = 1000;

/** @param {HTMLTableElement} table @returns {string[]} */
function headings(table) {
  return [...table.tHead.rows[0].cells].map((cell) => cell.textContent);
}

/**
 * Rows by what identifies them: the team, or else the first cell; facts by their place, since the leader becomes the winner.
 * @param {HTMLTableElement} table @returns {Map<string, HTMLTableRowElement>}
 */
function rowsByKey(table) {
  const names = headings(table);
  const column = Math.max(0, names.indexOf('team'));
  const key = (row, place) => (names[0] === 'what' ? String(place) : row.cells[column].textContent);
  return new Map([...table.tBodies[0].rows].map((row, place) => [key(row, place), row]));
}

/** Makes `target` what `source` is. */
function copyCell(target, source) {
  if (target.isEqualNode(source)) return;
  const focused = target.contains(document.activeElement);
  target.replaceChildren(...[...source.childNodes].map((node) => document.importNode(node, true)));
  target.title = source.title;
  if (focused) target.querySelector('a')?.focus();
}

/** @param {HTMLTableElement} table @param {HTMLTableElement} fetched */
function copyTable(table, fetched) {
  const columns = headings(table).map((heading) => headings(fetched).indexOf(heading));
  const rows = rowsByKey(table);
  for (const [key, source] of rowsByKey(fetched)) {
    const row = rows.get(key);
    if (row) columns.forEach((from, to) => from >= 0 && copyCell(row.cells[to], source.cells[from]));
    else table.tBodies[0].append(document.importNode(source, true));
  }
}

/** A button for tables whose rows have another order by now. */
function offerToSort(table, fetched) {
  const sorted = [...rowsByKey(fetched).keys()].join('\n') === [...rowsByKey(table).keys()].join('\n');
  const button = table.parentElement.querySelector('button');
  button.disabled = sorted;
  button.onclick = () => {
    table.replaceWith(document.importNode(fetched, true));
    button.disabled = true;
  };
}

/** @param {Document} fetched */
function copyPage(fetched) {
  document.getElementById('status').textContent = fetched.getElementById('status').textContent;
  const tables = [...document.querySelectorAll('table')];
  [...fetched.querySelectorAll('table')].forEach((source, i) => {
    if (!tables[i]) return;
    copyTable(tables[i], source);
    if (tables[i].parentElement.querySelector('button')) offerToSort(tables[i], source);
  });
}

/** One round; true while the tournament runs. */
async function pollList() {
  try {
    const response = await fetch('./', {cache: 'no-store'});
    if (!response.ok) throw new Error(String(response.status));
    const fetched = new DOMParser().parseFromString(await response.text(), 'text/html');
    copyPage(fetched);
    return fetched.body.hasAttribute('data-running');
  } catch {
    document.getElementById('status').textContent = 'No connection to cls; trying again';
    return true;
  }
}

async function followList() {
  for (const section of [...document.querySelectorAll('section')].slice(0, -1)) {
    const button = document.createElement('button');
    button.textContent = 'Sort';
    button.disabled = true;
    section.append(button);
  }
  while (await pollList()) await new Promise((resolve) => setTimeout(resolve, kListPollMs));
}

followList();
