// Books of situations (docs/formats/book.md): the situations of a file, and a book with one of them.
const kFormat = 'cls.book/1';
const kLargest = 200_000_000; // characters
const kClasses = { attack: 'attack', defense: 'defense', set_play: 'set play', turnover: 'turnover' };

function headerOf(line) {
  try {
    const header = JSON.parse(line);
    return header?.format === kFormat && Array.isArray(header.logs) ? header : null;
  } catch {
    return null;
  }
}

async function textOf(file) {
  const start = new Uint8Array(await file.slice(0, 2).arrayBuffer());
  if (start[0] !== 0x1f || start[1] !== 0x8b) return file.text();
  return new Response(file.stream().pipeThrough(new DecompressionStream('gzip'))).text();
}

/** @typedef {{header: any, situations: any[], labels: string[]}} Book */

/** Reads a file, plain or gzip. @param {File} file @returns {Promise<Book>} rejects with a sentence without a period */
export async function readBook(file) {
  const text = await textOf(file).catch(() => '');
  if (text.length > kLargest) throw new Error('the book is too large');
  const [first, ...lines] = text.split('\n').filter(Boolean);
  const header = headerOf(first ?? '');
  if (!header) throw new Error(`not a book of situations (${kFormat})`);
  try {
    const situations = lines.map((line) => JSON.parse(line));
    if (situations.length === 0) throw new Error('no situations');
    return { header, situations, labels: situations.map((situation) => labelOf(header, situation)) };
  } catch {
    throw new Error('the book is damaged, or has no situations');
  }
}

function labelOf(header, { class: kind, log, time }) {
  return `${kClasses[kind] ?? kind} at ${time}, ${header.logs[log].teams.join(' : ')}`;
}

/** The text of a book with one situation. @param {Book} book @param {number} index */
export function oneSituation({ header, situations }, index) {
  const situation = situations[index];
  return [{ ...header, logs: [header.logs[situation.log]] }, { ...situation, log: 0 }].map((line) => `${JSON.stringify(line)}\n`).join('');
}

/** True for the text of a book with one situation; the engine checks what is in it. @param {any} text */
export function isOneSituation(text) {
  if (typeof text !== 'string') return false;
  const lines = text.split('\n').filter(Boolean);
  return lines.length === 2 && headerOf(lines[0])?.logs.length === 1;
}
