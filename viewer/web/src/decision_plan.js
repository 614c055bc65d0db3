// What a player considered before it chose: first actions of the planner, or options of a policy (docs/formats/decisions.md).

/**
 * @typedef {{chosen: boolean, text: string, target: [number, number] | null, value: number, isShare: boolean}} Considered `text`: the line without its
 *   mark; `target`: of the own team's view; `value`: in percent if it is the share of a policy's option, otherwise the planner's
 */

const kLine = /^([*-]) (\S.*?)$/;
const kValue = / (-?[\d.]+)(%?)(?: room [\d.]+)?$/;
const kTarget = / \((-?[\d.]+), (-?[\d.]+)\) /;

/** The best first, of equal ones the chosen one. @param {string} plan @returns {Considered[]} */
export function consideredActions(plan) {
  const considered = plan.split('\n').flatMap((line) => {
    const [, mark, text] = kLine.exec(line) ?? [];
    const [, value, percent] = kValue.exec(text ?? '') ?? [];
    if (value === undefined) return [];
    const point = kTarget.exec(text);
    /** @type {[number, number] | null} */
    const target = point ? [Number(point[1]), Number(point[2])] : null;
    return [{chosen: mark === '*', text, target, value: Number(value), isShare: percent === '%'}];
  });
  return considered.sort((a, b) => b.value - a.value || Number(b.chosen) - Number(a.chosen));
}

/** @param {Considered[]} considered @returns {string} what its list is */
export function consideredTitle(considered) {
  return considered.some(({isShare}) => isShare) ? 'Options of the policy, most likely first' : 'Planner, best sequence first';
}
