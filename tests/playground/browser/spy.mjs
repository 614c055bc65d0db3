// A team that tries to reach the network and the visitor's storage.
import assert from 'node:assert/strict';
import { writeCode } from './site.mjs';

const SPY = `
const tried = {};
const tell = (name, what) => { tried[name] = String(what).slice(0, 60); };
const attempt = (name, run) => {
  try {
    Promise.resolve(run()).then((value) => tell(name, 'REACHED ' + value), (error) => tell(name, 'refused ' + error.name));
  } catch (error) {
    tell(name, 'refused ' + error.name);
  }
};
attempt('fetch', () => fetch('SITE/spy-fetch'));
attempt('foreign', () => fetch('http://192.0.2.1/spy', { mode: 'no-cors' }));
attempt('request', () => { const r = new XMLHttpRequest(); r.open('GET', 'SITE/spy-xhr', false); r.send(); return r.status; });
attempt('socket', () => new Promise((resolve, reject) => { const s = new WebSocket('ws://HOST/spy-socket'); s.onopen = resolve; s.onerror = () => reject(new Error('x')); }));
attempt('scripts', () => importScripts('SITE/spy-scripts.js'));
attempt('module', () => import('SITE/spy-module.js'));
attempt('database', () => new Promise((resolve, reject) => { const o = indexedDB.open('spy'); o.onsuccess = resolve; o.onerror = () => reject(o.error); }));
attempt('caches', () => caches.open('spy'));
attempt('storage', () => localStorage.getItem('cls-team'));
attempt('files', () => navigator.storage.getDirectory());
attempt('worker', () => new Promise((resolve, reject) => { const w = new Worker('SITE/spy-worker.js'); w.onerror = () => reject(new Error('x')); w.onmessage = resolve; setTimeout(() => reject(new Error('silent')), 1000); }));
postMessage({ kind: 'done', status: { failure: '' } });
let told = false;
export function decide(state) {
  if (!told && state.world_model.cycle >= 3) {
    told = true;
    console.log('TRIED ' + JSON.stringify(tried));
  }
  return { actions: [] };
}
export function decideAsCoach() { return {}; }
`;

const NAMES = ['caches', 'database', 'fetch', 'files', 'foreign', 'module', 'request', 'scripts', 'socket', 'storage', 'worker'];

/** Plays it at the step Write, and fails if anything was reached. */
export async function expectNothingReached(page, site) {
  const url = site.url.replace(/\/$/, '');
  await writeCode(page, SPY.replaceAll('SITE', url).replaceAll('HOST', new URL(url).host));
  await page.click('#play');
  await page.waitForFunction(() => /TRIED/.test(document.getElementById('output').textContent), null, { timeout: 500_000 });
  const output = await page.locator('#output').textContent();
  const tried = JSON.parse(/TRIED (\{.*?\})/.exec(output)[1]);
  for (const name of NAMES) assert.match(tried[name] ?? '', /^refused/, `${name}: ${tried[name]}`);
  assert.deepEqual(site.requests.filter((request) => request.includes('spy')), []);
}
