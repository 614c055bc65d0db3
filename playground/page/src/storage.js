// The visitor's team and steps in the browser's storage, which may be forbidden. Code of links is not kept there.
import { areTeamFiles, languageOf } from './team_files.js';

const kTeamKeys = { javascript: 'cls-team', python: 'cls-team-python' };
const kViewerKey = 'cls-viewer'; // of viewer/web/src/settings.js

export class Storage {
  #read(key) {
    try {
      return JSON.parse(window.localStorage.getItem(key) ?? 'null');
    } catch {
      return null;
    }
  }

  #write(key, value) {
    try {
      window.localStorage.setItem(key, JSON.stringify(value));
    } catch {
      // The team then lasts as long as the page.
    }
  }

  #team(key) {
    const team = this.#read(key);
    return typeof team?.name === 'string' && areTeamFiles(team.files) ? team : null;
  }

  /** The visitor's team in a language, or null. @param {import('./team_files.js').Language} language */
  teamIn(language) {
    const team = this.#team(kTeamKeys[language]);
    return team && languageOf(team.files) === language ? team : null;
  }

  /** The team of the language that was used last. */
  get team() {
    return this.teamIn(this.language);
  }

  set team(team) {
    this.language = languageOf(team.files);
    this.#write(kTeamKeys[this.language], team);
  }

  get language() {
    return this.#read('cls-language') === 'python' ? 'python' : 'javascript';
  }

  set language(language) {
    this.#write('cls-language', language);
  }

  get kept() {
    return this.#team('cls-kept-team');
  }

  set kept(team) {
    this.#write('cls-kept-team', team);
  }

  /** The steps of the tutorial that are done. @returns {string[]} */
  get lessons() {
    const ids = this.#read('cls-lessons');
    return Array.isArray(ids) ? ids : [];
  }

  set lessons(ids) {
    this.#write('cls-lessons', ids);
  }

  get viewerSettings() {
    return this.#read(kViewerKey) ?? {};
  }
}
