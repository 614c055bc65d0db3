// Matches of the program, to compare those of the page with.
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';

export const sha256 = (bytes) => createHash('sha256').update(bytes).digest('hex');

/** SHA-256 of the game log of `cls match`. @param {string[]} words of the command behind `match` @param {string} folder to work in */
export function hashOfCls(words, folder = '.') {
  const parent = mkdtempSync(path.join(os.tmpdir(), 'cls-page-'));
  try {
    const match = path.join(parent, 'match');
    execFileSync(process.env.CLS, ['match', ...words, '--dir', match], { cwd: folder, stdio: ['ignore', 'ignore', 'pipe'] });
    return sha256(readFileSync(path.join(match, 'match.rcg')));
  } finally {
    rmSync(parent, { recursive: true });
  }
}

// With permissions and times, as other programs do it: ./run looks at both.
const UNZIP = `
import os, sys, time, zipfile
archive = zipfile.ZipFile(sys.argv[1])
archive.extractall(sys.argv[2])
for entry in archive.infolist():
    file = os.path.join(sys.argv[2], entry.filename)
    os.chmod(file, entry.external_attr >> 16 & 0o777)
    os.utime(file, (time.mktime(entry.date_time + (0, 0, -1)),) * 2)
`;

/** Unpacks a project. */
export function unzip(archive, folder) {
  execFileSync('python3', ['-c', UNZIP, archive, folder]);
}

/** The words behind `cls match` in the README of a project. @param {string} text */
export function wordsOfReadme(text) {
  const [, command] = /^cls match (.*)$/m.exec(text);
  return Array.from(command.matchAll(/'([^']*)'|\S+/g), ([word, inner]) => inner ?? word);
}
