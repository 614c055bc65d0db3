// Angles and distances. Degrees, clockwise on the screen because y points down.

/** @param {number} degrees @returns {number} the same direction in (-180, 180] */
export function normalizedAngle(degrees) {
  const turned = degrees % 360;
  if (turned > 180) return turned - 360;
  return turned <= -180 ? turned + 360 : turned;
}

/** The direction between two angles, along the shorter arc.
 * @param {number} from @param {number} to @param {number} fraction 0 to 1 @returns {number} */
export function angleBetween(from, to, fraction) {
  return normalizedAngle(from + normalizedAngle(to - from) * fraction);
}

/** @param {number} degrees @returns {number} */
export function radians(degrees) {
  return (degrees * Math.PI) / 180;
}

/** @param {number} value @param {number} low @param {number} high @returns {number} */
export function clamp(value, low, high) {
  return Math.min(high, Math.max(low, value));
}
