// Parts of the program that only some pages have.

/**
 * @typedef {object} DecisionExtension the decision debugger: decision_debugger.js
 * @property {(record: import('./record.js').MatchRecord) => any} makeStore the decisions of the page
 * @property {(viewer: import('./viewer.js').Viewer) => {root: Element, show: () => void}} makePanel
 * @property {(scene: import('./scene.js').Scene) => void} draw estimates and what was considered, on the field
 */

/**
 * @typedef {object} DrawingExtension texts and drawings of Playmakers: team_drawings.js
 * @property {(record: import('./record.js').MatchRecord) => import('./drawing_store.js').DrawingStore} makeStore
 * @property {(viewer: import('./viewer.js').Viewer) => {root: Element, show: () => void}} makePanel
 * @property {(path: string, store: import('./drawing_store.js').DrawingStore, onChange: () => void, prefix?: string) => Promise<void>} read
 * those of the page, or from the server of a running match
 * @property {(scene: import('./scene.js').Scene) => void} draw
 */

/**
 * @typedef {(root: HTMLElement, records: import('./record.js').MatchRecord[], differences: any, settings: import('./settings.js').Settings,
 * host: any) => any} ComparisonExtension two matches side by side: comparison.js
 */

/** @type {{decisions: DecisionExtension | null, drawings: DrawingExtension | null, compare: ComparisonExtension | null}} */
export const kExtensions = {decisions: null, drawings: null, compare: null};

/** What a page without texts and drawings says. */
export const kNothingShown = 'This page has no texts or drawings: no Playmaker of the match used the actions log or debug_client, or the page was made without the folder of its match.';
