// Joins the page as the build does, so that its tests need no build of cls.
import crypto from 'node:crypto';
import fs from 'node:fs';
import zlib from 'node:zlib';

const kWeb = new URL('../../../viewer/web/', import.meta.url);

function script() {
  const lines = ["(() => {'use strict';"];
  for (const name of fs.readFileSync(new URL('modules.txt', kWeb), 'utf8').trim().split('\n')) {
    const text = fs.readFileSync(new URL(`src/${name}`, kWeb), 'utf8');
    for (const line of text.split('\n')) {
      if (!line.startsWith('import ')) lines.push(line.replace(/^export /, ''));
    }
  }
  return `${lines.join('\n')}\n})();\n`;
}

const hashSource = (text) => `'sha256-${crypto.createHash('sha256').update(text).digest('base64')}'`;

/** @param {Buffer} stream @param {any} [settings] @returns {string} HTML */
export function pageOf(stream, settings = {}) {
  const code = script();
  const style = fs.readFileSync(new URL('style.css', kWeb), 'utf8');
  const data = zlib.gzipSync(stream, {level: 6}).toString('base64');
  const policy = `default-src 'none'; script-src ${hashSource(code)}; style-src ${hashSource(style)}; img-src data: blob:; base-uri 'none'; form-action 'none'`;
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1"><title>Replay</title><style>${style}</style></head>
<body><noscript>A replay</noscript><div id="app"></div>
<script type="application/json" id="settings">${JSON.stringify(settings).replaceAll('<', '\\u003c')}</script>
<script>${code}</script>
<script type="application/cls-view;base64" id="match" data-length="${data.length}">${data}</script></body></html>
`;
}
