// Parts of the program that only some pages have.

/**
 * @typedef {object} DecisionExtension the decision debugger: decision_debugger.js
 * @property {(record: import('./record.js').MatchRecord) => any} makeStore the decisions of the page
 * @property {(viewer: import('./viewer.js').Viewer) => {root: Element, show: () => void}} makePanel
 * @property {(scene: import('./scene.js').Scene) => void} draw estimates on the field
 */

/** @type {{decisions: DecisionExtension | null}} */
export const kExtensions = {decisions: null};
