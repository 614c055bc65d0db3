// The visitor's team and steps in the browser's storage, which may be forbidden. Code of links is not kept there.
import { areTeamFiles } from './team_files.js';

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

  get team() {
    return this.#team('cls-team');
  }

  set team(team) {
    this.#write('cls-team', team);
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
