// The npm package: what it holds, and the examples of its README as they are.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

const build = dirname(dirname(process.env.CLS_ENGINE));
const tarball = readdirSync(build).find((name) => /^cls-match-.*\.tgz$/.test(name));
const skip = tarball ? false : 'no package (make npm)';
let project;

before(() => {
  if (skip) return;
  project = mkdtempSync(join(tmpdir(), 'cls-match-'));
  writeFileSync(join(project, 'package.json'), '{"type": "module", "private": true}');
  execFileSync('npm', ['install', '--offline', '--silent', '--no-audit', '--no-fund', join(build, tarball)],
    { cwd: project });
});
after(() => {
  if (project) rmSync(project, { recursive: true });
});

/** What a program of the project prints. */
function run(name, source) {
  writeFileSync(join(project, name), source);
  return execFileSync(process.execPath, [name], { cwd: project, encoding: 'utf8' });
}

test('the package has the program, its types and no other file', { skip }, () => {
  const files = readdirSync(join(project, 'node_modules/cls-match')).sort();
  assert.deepEqual(files, ['LICENSE', 'README.md', 'cls.wasm', 'engine.js', 'index.d.ts', 'index.js',
    'messages.js', 'package.json', 'teams.js']);
  const manifest = JSON.parse(readFileSync(join(project, 'node_modules/cls-match/package.json')));
  assert.match(manifest.version, /^\d+\.\d+\.\d+$/);
  assert.notEqual(manifest.version, '0.0.0');
  assert.equal(manifest.dependencies, undefined);
});

const readme = readFileSync(fileURLToPath(new URL('../../../playground/web/README.md', import.meta.url)),
  'utf8');
const examples = [...readme.matchAll(/^## (.*?)$[\s\S]*?```js\n([\s\S]*?)```/gm)];

test('the README has three examples', () => assert.equal(examples.length, 3));

const EXPECTED = {
  'A match of bundled teams': (output) => assert.equal(output, 'planner 0:0 simple\n'),
  'A team of your own': (output) => {
    assert.equal(output, 'played to cycle 200\n');
    assert.ok(existsSync(join(project, 'chaser.rcg')));
  },
  'A match in pieces': (output) => assert.match(output, /^\d+ [a-z_]+\n(\d+ [a-z_]+\n)+$/),
};

for (const [, title, source] of examples) {
  test(`the example "${title}" prints what the README says`, { skip }, () => {
    EXPECTED[title](run('example.js', source));
  });
}

test('a wrong side or setup is an error of one line', { skip }, () => {
  const output = run('wrong.js', `
    import { playMatch } from 'cls-match';
    const tell = (error) => console.log(String(error));
    await playMatch({ left: 'mock:plannr', right: 'mock' }).catch(tell);
    await playMatch({ left: {}, right: 'mock' }).catch(tell);
    await playMatch({ left: 'mock', right: 'mock', signal: AbortSignal.abort() }).catch(tell);
    await playMatch({
      left: 'mock', right: { decide: () => ({ actions: {} }) },
    }).then((result) => console.log(result.failure));
  `);
  const lines = output.trim().split('\n');
  assert.equal(lines.length, 4);
  assert.match(lines[0], /planner/);
  assert.match(lines[1], /TypeError: left must be a side such as 'mock:planner'/);
  assert.match(lines[2], /AbortError/);
  assert.match(lines[3], /protos\.PlayerActions\.actions: array expected/);
});
