// A team as the project that `cls match` plays: its files and a Playmaker around them.
import { languageOf, mainFileOf } from './team_files.js';
import { zipOf } from './zip.js';

const kOpponent = 'opponent';
const kBook = 'situation.book';
/** What differs between languages: their names, the tools that a project needs, and the folder of the team's files. */
const kLanguages = {
  javascript: { name: 'JavaScript', tools: 'Node.js 18 and npm', folder: 'src/' },
  python: { name: 'Python', tools: 'Python 3.9 with grpcio (Debian: python3-grpcio and protobuf-compiler-grpc)', folder: '' },
};

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

function readmeOf(teams, command) {
  const [team] = teams;
  const builds = ['./run build', `${kOpponent}/run build`].slice(0, teams.length);
  const { name, tools, folder } = kLanguages[languageOf(team.files)];
  return `# ${team.name}

A team for RoboCup 2D soccer simulation in ${name}, from the page of \`cls\` that plays matches in the browser.
\`${folder}${mainFileOf(team.files)}\` has its decisions. It needs \`cls\` and ${tools}:

\`\`\`sh
${builds.join('\n')}
${command}
cls watch runs
cls test tests/
\`\`\`

\`cls match\` plays the match of the page, with the same bytes in \`match.rcg\` and \`match.rcl\`.
`;
}

/**
 * The project of a match in which a team with code of its own plays; if both are such teams, the second one is in a folder.
 * @param {import('./share_link.js').SharedMatch} match @param {Record<string, Record<string, string>>} around the files
 *   around a team, by language and path; @NAME@ stands for its name
 * @returns {Blob} a ZIP archive
 */
export function projectOf(match, around) {
  const teams = [match.left, match.right].filter((side) => typeof side !== 'string');
  const files = { 'README.md': readmeOf(teams, commandOf(match)) };
  teams.forEach((team, i) => {
    const folder = i === 0 ? '' : `${kOpponent}/`;
    const language = languageOf(team.files);
    for (const [path, text] of Object.entries(around[language])) files[folder + path] = text.replaceAll('@NAME@', team.name);
    for (const [name, text] of Object.entries(team.files)) files[folder + kLanguages[language].folder + name] = text;
  });
  if (match.book !== null) files[kBook] = match.book;
  return zipOf(files, (path) => /(^|\/)run$/.test(path));
}
