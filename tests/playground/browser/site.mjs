// The page of the playground in a browser, from a static server on loopback.
import fs from 'node:fs';
import http from 'node:http';
import path from 'node:path';
import { launch, openPage } from '../../viewer/browser/browser.mjs';

const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm' };

/** Serves a folder as any static host does, and lists what was asked for. */
export async function serve(folder) {
  const requests = [];
  const server = http.createServer((request, response) => {
    const name = new URL(request.url, 'http://host').pathname.slice(1) || 'index.html';
    requests.push(request.url);
    const file = path.join(folder, path.basename(name));
    if (!fs.existsSync(file)) return response.writeHead(404).end();
    response.setHeader('Content-Type', TYPES[path.extname(file)] ?? 'application/octet-stream');
    response.end(fs.readFileSync(file));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return { url: `http://127.0.0.1:${server.address().port}/`, requests, close: () => server.close() };
}

/** A browser, Chromium by default, and the site; `open` gives a page with a storage of its own. */
export async function startSite(folder = process.env.CLS_PAGE, start = launch) {
  const site = await serve(folder);
  const browser = await start();
  return {
    ...site,
    browser,
    open: (hash = '', options = {}) => openPage(browser, site.url + hash, new RegExp(`^(${site.url}|blob:|data:)`), options),
    close: async () => {
      await browser.close();
      site.close();
    },
  };
}

/** The viewer of the page. */
export const fieldOf = (page) => page.frameLocator('#field iframe');

/** The frame of the viewer that shows the current match. */
export function viewerFrame(page) {
  return page.frames().findLast((frame) => frame.url().endsWith('/field.html') || frame.url().includes('/field.html#'));
}

/** The frame that shows at least `frames` frames of a match. */
export async function whenShown(page, frames = 1, timeout = 60_000) {
  const until = Date.now() + timeout;
  for (;;) {
    const shown = await viewerFrame(page)?.evaluate(() => window.clsViewer?.viewer.record.frames ?? 0).catch(() => 0);
    if (shown >= frames) return;
    if (Date.now() > until) throw new Error(`the viewer shows ${shown} frames after ${timeout} ms: ${await page.locator('#result').textContent()}`);
    await page.waitForTimeout(50);
  }
}

/** Waits for a line of the result. @param {RegExp} pattern */
export async function resultMatches(page, pattern, timeout = 120_000) {
  await page.waitForFunction(([source, flags]) => new RegExp(source, flags).test(document.getElementById('result').textContent),
    [pattern.source, pattern.flags], { timeout, polling: 100 });
  return page.locator('#result').textContent();
}

/** Waits for the end of a match. @returns {Promise<string>} SHA-256 of its game log */
export async function playedHash(page) {
  await resultMatches(page, /cycles at/, 500_000);
  await page.waitForFunction(() => document.getElementById('result').dataset.hash);
  return page.locator('#result').getAttribute('data-hash');
}

/** The address that the dialog gives. @returns {Promise<URL>} */
export async function sharedLink(page) {
  await page.click('#share');
  await page.locator('#share-dialog[open]').waitFor();
  const link = new URL(await page.inputValue('#share-link'));
  await page.click('#share-close');
  return link;
}

/** Replaces the text of the open file as a visitor does by pasting. */
export async function writeCode(page, text) {
  await page.evaluate((code) => {
    const { view } = window.clsPlayground.editor;
    view.dispatch({ changes: { from: 0, to: view.state.doc.length, insert: code } });
  }, text);
}
