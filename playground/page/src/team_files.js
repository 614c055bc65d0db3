// The files of a team in the page: those of a project of `cls new NAME javascript`, and what they import.
import { javascriptLanguage } from '@codemirror/lang-javascript';
import actions from '../../../examples/javascript/src/actions.js?text';
import situation from '../../../examples/javascript/src/situation.js?text';
import decide from '../../../examples/minimal/decide.js?text';
import pythonDecide from '../../../examples/minimal/decide.py?text';
import pythonActions from '../../../examples/python/actions.py?text';
import pythonSituation from '../../../examples/python/situation.py?text';

/** @typedef {'javascript' | 'python'} Language */

const kJavascriptMain = 'decide.js';
const kPythonMain = 'decide.py';
/** The first version of a team, by language. */
export const kTemplates = Object.freeze({
  javascript: { [kJavascriptMain]: decide, 'actions.js': actions, 'situation.js': situation },
  python: { [kPythonMain]: pythonDecide, 'actions.py': pythonActions, 'situation.py': pythonSituation },
});
const kLargestFile = 200_000; // characters

/** @param {Record<string, string>} files @returns {Language} */
export function languageOf(files) {
  return kPythonMain in files ? 'python' : 'javascript';
}

/** The file that decides. @param {Record<string, string>} files */
export function mainFileOf(files) {
  return kPythonMain in files ? kPythonMain : kJavascriptMain;
}

/** What is wrong with a team's code, and where. */
export class CodeError extends Error {
  constructor(file, line, text) {
    super(`${text} (${file}:${line})`);
    this.file = file;
    this.line = line;
    this.text = text;
  }
}

/** The first place that a text names as "(FILE:LINE)". @param {string} text @returns {{file: string, line: number} | null} */
export function placeIn(text) {
  const place = /\(([\w.-]+\.(?:js|py)):(\d+)\)/.exec(text);
  return place && { file: place[1], line: Number(place[2]) };
}

/** True for files as the page has them: texts by name, with the one that decides. */
export function areTeamFiles(files) {
  if (typeof files !== 'object' || files === null || typeof files[mainFileOf(files)] !== 'string') return false;
  const template = kTemplates[languageOf(files)];
  return Object.entries(files).every(([name, text]) => Object.hasOwn(template, name) && typeof text === 'string' && text.length <= kLargestFile);
}

/** The modules that a team in JavaScript consists of, each after those that it imports, as team_modules.js loads them.
 * Throws a CodeError. */
export function modulesOf(files) {
  const modules = [];
  const open = new Set();
  const add = (name, from, line) => {
    if (modules.some((module) => module.name === name)) return;
    if (open.has(name)) throw new CodeError(from, line, `${name} imports itself through other modules`);
    open.add(name);
    const pieces = piecesOf(name, files);
    for (const piece of pieces) if (typeof piece !== 'string') add(piece.module, name, piece.line);
    modules.push({ name, pieces });
  };
  add(kJavascriptMain, kJavascriptMain, 1);
  return modules;
}

/** The files that the team needs. */
export function reachableFiles(files) {
  if (languageOf(files) === 'python') return { ...files };
  try {
    return Object.fromEntries(modulesOf(files).map(({ name }) => [name, files[name]]).reverse());
  } catch {
    return { ...files };
  }
}

function piecesOf(name, files) {
  const text = files[name];
  const pieces = [];
  let at = 0;
  for (const { from, to } of importsOf(text)) {
    const specifier = text.slice(from + 1, to - 1);
    const module = specifier.replace(/^\.\//, '');
    const line = lineAt(text, from);
    if (!specifier.startsWith('./') || !(module in files)) {
      const known = Object.keys(files).filter((file) => file !== name).map((file) => `'./${file}'`).join(' and ');
      throw new CodeError(name, line, `no module '${specifier}' here; there are ${known}`);
    }
    pieces.push(text.slice(at, from + 1), { module, line });
    at = to - 1;
  }
  pieces.push(text.slice(at));
  return pieces;
}

/** The places of the texts behind `from` and `import`. */
function importsOf(text) {
  const found = [];
  const tree = javascriptLanguage.parser.parse(text);
  for (let node = tree.topNode.firstChild; node; node = node.nextSibling) {
    if (node.name !== 'ImportDeclaration' && node.name !== 'ExportDeclaration') continue;
    const source = node.getChild('String');
    if (source) found.push({ from: source.from, to: source.to });
  }
  return found;
}

/** The line of the first thing that is not JavaScript, or 0. */
export function syntaxErrorLine(text) {
  let line = 0;
  javascriptLanguage.parser.parse(text).iterate({
    enter(node) {
      if (line === 0 && node.type.isError) line = lineAt(text, node.from);
    },
  });
  return line;
}

export function lineAt(text, at) {
  return text.slice(0, at).split('\n').length;
}
