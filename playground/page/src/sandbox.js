// The document of a sandboxed frame: it starts and ends the workers that play. Its origin is opaque and its policy
// allows no connection, and its workers inherit both: a team reaches neither storage nor network.
import workerProgram from 'bundled:worker.js';

const address = URL.createObjectURL(new Blob([workerProgram], { type: 'text/javascript' }));
const workers = new Map(); // by number of the match

let engine; // compiled once, for all workers

function start(number, port) {
  // A module would have to come from an origin that is not opaque.
  const worker = new Worker(address);
  workers.set(number, worker);
  worker.onerror = (event) => {
    event.preventDefault();
    tell({ kind: 'died', number, message: event.message ?? '' });
  };
  worker.postMessage({ engine, port }, [port]);
}

function end(number) {
  workers.get(number)?.terminate();
  workers.delete(number);
  tell({ kind: 'ended', number });
}

function tell(message) {
  window.parent.postMessage(message, '*');
}

window.addEventListener('message', async ({ source, data, ports }) => {
  if (source !== window.parent) return;
  if (data.kind === 'start') start(data.number, ports[0]);
  if (data.kind === 'end') end(data.number);
  if (data.kind !== 'engine') return;
  engine = await WebAssembly.compile(data.bytes);
  tell({ kind: 'ready' });
});
tell({ kind: 'waiting' });
