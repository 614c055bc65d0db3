// A team as the project that `cls match` plays: its files and a Playmaker around them.
import { zipOf } from './zip.js';

const kOpponent = 'opponent';
const kBook = 'situation.book';

/** @param {string} word of a command */
const quoted = (word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word}'`);

/** What `cls match` needs for the same match: arguments behind both sides. @param {import('./share_link.js').SharedMatch} match */
function optionsOf({ seed, cycles, set, book }) {
  return [
    '--seed', seed, ...(cycles === null ? [] : ['--cycles', cycles]), ...set.flatMap((setting) => ['--set', setting]),
    ...(book === null ? [] : ['--book', kBook, '--situations', 1]),
  ];
}

/** The command for the match in the folder of a project. @param {import('./share_link.js').SharedMatch} match */
export function commandOf(match) {
  const own = [match.left, match.right].find((side) => typeof side !== 'string');
  const folder = (side) => (side === own ? '.' : kOpponent);
  const sides = [match.left, match.right].map((side) => (typeof side === 'string' ? side : `run:${folder(side)}/run --port {port} --coach`));
  const names = [['--left-name', match.left], ['--right-name', match.right]].flatMap(([option, side]) => (typeof side === 'string' ? [] : [option, side.name]));
  return ['cls', 'match', ...sides, ...names, ...optionsOf(match)].map((word) => quoted(String(word))).join(' ');
}

function readmeOf(team, command) {
  return `# ${team.name}

A team for RoboCup 2D soccer simulation in JavaScript, from the page of \`cls\` that plays matches in the browser.
\`src/decide.js\` has its decisions. It needs \`cls\`, Node.js 18 and npm:

\`\`\`sh
./run build
${command}
cls watch runs
cls test tests/
\`\`\`

The second command plays the match of the page, with the same bytes in \`match.rcg\` and \`match.rcl\`.
`;
}

/**
 * The project of a match in which a team in JavaScript plays; if both sides do, the second one is in a folder of its own.
 * @param {import('./share_link.js').SharedMatch} match @param {Record<string, string>} around the files around a team, by
 *   path; @NAME@ stands for its name
 * @returns {Blob} a ZIP archive
 */
export function projectOf(match, around) {
  const teams = [match.left, match.right].filter((side) => typeof side !== 'string');
  const files = { 'README.md': readmeOf(teams[0], commandOf(match)) };
  teams.forEach((team, i) => {
    const folder = i === 0 ? '' : `${kOpponent}/`;
    for (const [path, text] of Object.entries(around)) files[folder + path] = text.replaceAll('@NAME@', team.name);
    for (const [name, text] of Object.entries(team.files)) files[`${folder}src/${name}`] = text;
  });
  if (match.book !== null) files[kBook] = match.book;
  return zipOf(files, (path) => /(^|\/)run$/.test(path));
}
