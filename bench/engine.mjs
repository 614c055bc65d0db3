#!/usr/bin/env node
// Cycles per second of the native program and of the engine in WebAssembly, side by side, and what the
// engine weighs: bench/engine.mjs [CLS [WASM]]. The native program uses two threads, the engine one.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { loadavg, tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { Engine } from '../playground/web/engine.js';

const CYCLES = 1500;
const SEED = 7;
const root = fileURLToPath(new URL('..', import.meta.url));
const [cls = `${root}build/bin/cls`, wasm = `${root}build-playground/bin/cls.wasm`] = process.argv.slice(2);

function nativeSpeed(side) {
  const folder = mkdtempSync(join(tmpdir(), 'cls-bench-'));
  try {
    execFileSync(cls, ['match', side, side, '--seed', SEED, '--cycles', CYCLES, '--dir', join(folder, 'match')]);
    return JSON.parse(readFileSync(join(folder, 'match/result.json'))).cycles_per_second;
  } finally {
    rmSync(folder, { recursive: true });
  }
}

async function engineSpeed(side) {
  const match = (await Engine.create(readFileSync(wasm))).start({ left: side, right: side, seed: SEED, cycles: CYCLES });
  const began = performance.now();
  while (match.play(100)) {
    match.takeGameLog();
    match.takeTextLog();
  }
  return CYCLES / ((performance.now() - began) / 1000);
}

if (!existsSync(wasm)) {
  console.log(`engine skipped: no ${wasm} (make playground)`);
  process.exit(0);
}
console.log(`cycles/s of ${CYCLES} cycles   native   WebAssembly`);
for (const side of ['mock:planner', 'mock:simple']) {
  const native = nativeSpeed(side);
  const engine = await engineSpeed(side);
  console.log(`${side.padEnd(26)}${native.toFixed(0).padStart(6)}${engine.toFixed(0).padStart(14)}`);
}
const bytes = readFileSync(wasm);
const mega = (size) => `${(size / 1e6).toFixed(2)} MB`;
console.log(`cls.wasm ${mega(bytes.length)}, gzip ${mega(gzipSync(bytes, { level: 9 }).length)}, `
  + `brotli ${mega(brotliCompressSync(bytes).length)}; load ${loadavg()[0].toFixed(1)}`);
