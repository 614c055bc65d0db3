// Joins the page as the build does, so that its tests need no build of cls.
import crypto from 'node:crypto';
import fs from 'node:fs';
import zlib from 'node:zlib';

const kWeb = new URL('../../../viewer/web/', import.meta.url);

const kComment = /^ *(\/\/|\/\*\*|\*( |\/))/;

/** @param {string[]} parts of the program that only some pages have */
function script(parts) {
  const lines = ["(() => {'use strict';"];
  for (const [name, part] of fs.readFileSync(new URL('modules.txt', kWeb), 'utf8').trim().split('\n').map((line) => line.split(' '))) {
    if (part && !parts.includes(part)) continue;
    const text = fs.readFileSync(new URL(`src/${name}`, kWeb), 'utf8');
    for (const line of text.split('\n')) {
      if (!line.startsWith('import ') && !kComment.test(line)) lines.push(line.replace(/^export /, ''));
    }
  }
  return `${lines.join('\n')}\n})();\n`;
}

const hashSource = (text) => `'sha256-${crypto.createHash('sha256').update(text).digest('base64')}'`;

function dataElement(kind, id, stream) {
  const data = zlib.gzipSync(stream, {level: 6}).toString('base64');
  return `<script type="application/cls-${kind};base64" id="${id}" data-length="${data.length}">${data}</script>\n`;
}

/** The parts of the program that a page has, as script_of() in viewer/page/page.cpp chooses them. */
function partsOf(settings, decisions, drawings) {
  if (settings.compared) return ['drawings', 'comparison'];
  if (Object.keys(decisions).length > 0) return ['drawings', 'decisions'];
  return Object.keys(drawings).length > 0 || settings.drawings ? ['drawings'] : [];
}

/** @param {Buffer | null} stream null for a live page @param {any} [settings] @param {Record<string, Buffer>} [decisions] by side
 * @param {Record<string, string>} [drawings] debug logs by side @returns {string} HTML */
export function pageOf(stream, settings = {}, decisions = {}, drawings = {}) {
  const code = script(partsOf(settings, decisions, drawings));
  const style = fs.readFileSync(new URL('style.css', kWeb), 'utf8');
  const match = stream ? dataElement('view', 'match', stream) : '';
  const recorded = Object.entries(decisions).map(([side, bytes]) => dataElement('decisions', `decisions-${side}`, bytes)).join('');
  const shown = Object.entries(drawings).map(([side, lines]) => dataElement('drawings', `drawings-${side}`, Buffer.from(lines))).join('');
  const connect = stream ? '' : "connect-src 'self'; ";
  const policy = `default-src 'none'; script-src ${hashSource(code)}; style-src ${hashSource(style)}; img-src data: blob:; ${connect}base-uri 'none'; form-action 'none'`;
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<link rel="icon" href="data:,"><meta name="viewport" content="width=device-width, initial-scale=1"><title>Replay</title><style>${style}</style></head>
<body><noscript>A replay</noscript><div id="app"></div>
<script type="application/json" id="settings">${JSON.stringify(settings).replaceAll('<', '\\u003c')}</script>
<script>${code}</script>
${match}${recorded}${shown}</body></html>
`;
}
