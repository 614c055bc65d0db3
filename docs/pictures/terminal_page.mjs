// What a recording of `cls watch --cast` shows at a moment, as an HTML page: the sequences that viewer/terminal writes, cell by cell.

const kEmpty = Object.freeze({text: ' ', style: ''});
/** Of viewer/terminal/screen.cpp: 256-color numbers of the teams. */
const kColors = {75: '#5fafff', 215: '#ffaf5f'};

function styleOf(codes) {
  const styles = [];
  let color = '#e6e9ee';
  for (let i = 0; i < codes.length; ++i) {
    if (codes[i] === 1) styles.push('font-weight:700');
    if (codes[i] === 2) styles.push('opacity:.55');
    if (codes[i] === 38) {
      color = kColors[codes[i + 2]] ?? color;
      i += 2;
    }
  }
  return [...styles, ...(codes.includes(7) ? [`background:${color}`, 'color:#14181d'] : [`color:${color}`])].join(';');
}

/** Applies output to the screen: cursor positions, styles, text. */
function write(screen, output) {
  for (const [whole, control] of output.matchAll(/\x1b\[\??([\d;]*[A-Za-z])|\x1b.|[^\x1b]+/g)) {
    const numbers = (control ?? '').slice(0, -1).split(';').map(Number);
    if (!whole.startsWith('\x1b')) {
      for (const letter of whole) put(screen, letter);
    } else if (control?.endsWith('H')) {
      [screen.row, screen.column] = [(numbers[0] || 1) - 1, (numbers[1] || 1) - 1];
    } else if (control?.endsWith('m')) {
      screen.style = styleOf(numbers);
    } else if (control?.endsWith('J')) {
      screen.cells = screen.cells.map((cells) => cells.map(() => kEmpty));
    }
  }
}

function put(screen, letter) {
  if (letter < ' ') return;
  if (screen.cells[screen.row]?.[screen.column]) screen.cells[screen.row][screen.column] = {text: letter, style: screen.style};
  ++screen.column;
}

const escaped = (text) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

/** @param {string} cast asciicast v2 @param {number} seconds @returns {string} HTML */
export function pageOfCast(cast, seconds) {
  const [head, ...lines] = cast.trim().split('\n').map((line) => JSON.parse(line));
  const screen = {row: 0, column: 0, style: '', cells: Array.from({length: head.height}, () => new Array(head.width).fill(kEmpty))};
  for (const [at, , output] of lines) {
    if (at > seconds) break;
    write(screen, output);
  }
  const rows = screen.cells.map((cells) => `<div>${cells.map(({text, style}) => `<span style="${style}">${escaped(text)}</span>`).join('')}</div>`);
  return `<!doctype html><meta charset="utf-8"><style>
body { margin: 0; padding: 14px 18px; background: #14181d; color: #e6e9ee; font: 16px/20px 'DejaVu Sans Mono', monospace; width: fit-content; }
div { white-space: pre; height: 20px; }
span { display: inline-block; width: 10px; height: 20px; text-align: center; overflow: hidden; }
</style>${rows.join('')}`;
}
