// A played match as one file: the page that `cls watch` makes of its logs, without statistics.

/** @param {Uint8Array[]} pieces @returns {Promise<string>} base64 of their gzip */
async function packed(pieces) {
  const bytes = await new Response(new Blob(pieces).stream().pipeThrough(new CompressionStream('gzip'))).blob();
  const address = await new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(reader.result);
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(bytes);
  });
  return address.slice(address.indexOf(',') + 1);
}

async function dataElement(kind, id, pieces) {
  const data = await packed(pieces);
  return `<script type="application/cls-${kind};base64" id="${id}" data-length="${data.length}">${data}</script>\n`;
}

/**
 * @param {{viewer: string, debugger: string}} starts of pages, without and with decisions: @TITLE@ stands for the title
 * @param {{title: string, view: Uint8Array[], decisions: Uint8Array[] | null}} match its stream, and the decisions of both sides
 */
export async function replayPage(starts, { title, view, decisions }) {
  const start = decisions ? starts.debugger : starts.viewer;
  const parts = [start.replace('@TITLE@', () => title.replaceAll('&', '&amp;').replaceAll('<', '&lt;')), await dataElement('view', 'match', view)];
  for (const [i, side] of ['left', 'right'].entries()) {
    if (decisions) parts.push(await dataElement('decisions', `decisions-${side}`, [decisions[i]]));
  }
  return new Blob([...parts, '</body>\n</html>\n'], { type: 'text/html' });
}
