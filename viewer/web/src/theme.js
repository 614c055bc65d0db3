// Colors of the canvas. Team colors are a pair of Okabe and Ito that all color visions can distinguish.

/**
 * @typedef {{surround: string, grass: string, stripe: string, line: string, net: string, ball: string, ballEdge: string,
 *   shadow: string, text: string, halo: string, warn: string, mark: string, tackle: string, catch: string, left: TeamColors,
 *   right: TeamColors, timeline: TimelineColors}} Theme
 * @typedef {{fill: string, ink: string, ring: string, glow: string}} TeamColors
 * @typedef {{back: string, play: string, pause: string, text: string, cursor: string, grid: string}} TimelineColors
 */

/** @type {Theme} */
const kDarkTheme = {
  surround: '#12271f',
  grass: '#1d4233',
  stripe: '#204938',
  line: 'rgba(236, 246, 240, 0.72)',
  net: 'rgba(236, 246, 240, 0.22)',
  ball: '#ffffff',
  ballEdge: '#0b1512',
  shadow: 'rgba(0, 0, 0, 0.38)',
  text: '#f4f8f6',
  halo: 'rgba(8, 20, 15, 0.75)',
  warn: '#ff7b72',
  mark: '#ffffff',
  tackle: '#f0a3d0',
  catch: '#f0e442',
  left: {fill: '#5ab8f2', ink: '#06202f', ring: '#ffffff', glow: 'rgba(90, 184, 242, '},
  right: {fill: '#f2a73b', ink: '#2b1700', ring: '#fff3dc', glow: 'rgba(242, 167, 59, '},
  timeline: {back: '#1b2129', play: '#2b4a3d', pause: '#323a45', text: '#aab4c0', cursor: '#ffffff', grid: '#3a434f'},
};

/** @type {Theme} */
const kLightTheme = {
  surround: '#6fa883',
  grass: '#86bd97',
  stripe: '#7fb791',
  line: 'rgba(255, 255, 255, 0.95)',
  net: 'rgba(255, 255, 255, 0.45)',
  ball: '#ffffff',
  ballEdge: '#10201a',
  shadow: 'rgba(10, 40, 25, 0.28)',
  text: '#0d1f17',
  halo: 'rgba(255, 255, 255, 0.8)',
  warn: '#a4161a',
  mark: '#ffffff',
  tackle: '#7a1f5c',
  catch: '#fff3a3',
  left: {fill: '#0b5fa5', ink: '#ffffff', ring: '#ffffff', glow: 'rgba(11, 95, 165, '},
  right: {fill: '#b84a00', ink: '#ffffff', ring: '#ffffff', glow: 'rgba(184, 74, 0, '},
  timeline: {back: '#e3e7eb', play: '#bcdcc8', pause: '#cfd5dc', text: '#4a5561', cursor: '#10161d', grid: '#b4bdc7'},
};

/** @param {'dark' | 'light'} name @returns {Theme} */
export function themeOf(name) {
  return name === 'light' ? kLightTheme : kDarkTheme;
}

/** @param {Theme} theme @param {number} slot @returns {TeamColors} */
export function teamColors(theme, slot) {
  return slot < 11 ? theme.left : theme.right;
}
