// Links to a moment: #t=1234+7&p=l7,r1&s=0.5&z=2.5,10,-3&d=1&play=1
import {kSlots, shortNameOfSlot, slotOfShortName} from './sides.js';

/**
 * @typedef {{time: number | null, stopped: number, selected: number[] | null, speed: number | null,
 *   view: {zoom: number, x: number, y: number} | null, follow: string, debugging: boolean, play: boolean}} Moment
 */

/** Reads what it understands and ignores the rest. @param {string} hash @returns {Moment} */
export function parseHash(hash) {
  const moment = {time: null, stopped: 0, selected: null, speed: null, view: null, follow: '', debugging: false, play: false};
  for (const part of hash.replace(/^#/, '').split('&')) {
    const equals = part.indexOf('=');
    const key = part.slice(0, Math.max(0, equals));
    const value = part.slice(equals + 1).replaceAll('%2B', '+').replaceAll('%2C', ',');
    if (key === 't') readTime(value, moment);
    if (key === 'p') moment.selected = slotsOfNames(value.split(','));
    if (key === 's' && /^\d+(\.\d+)?$/.test(value)) moment.speed = Number(value);
    if (key === 'z') readView(value, moment);
    if (key === 'f' && (value === 'ball' || value === 'player')) moment.follow = value;
    if (key === 'd') moment.debugging = value === '1';
    if (key === 'play') moment.play = value === '1';
  }
  return moment;
}

function readTime(value, moment) {
  const match = /^(\d{1,7})(?:\+(\d{1,7}))?$/.exec(value);
  if (!match) return;
  moment.time = Number(match[1]);
  moment.stopped = Number(match[2] ?? 0);
}

function readView(value, moment) {
  const numbers = value.split(',').map(Number);
  if (numbers.length === 3 && numbers.every(Number.isFinite)) moment.view = {zoom: numbers[0], x: numbers[1], y: numbers[2]};
}

/** @param {string[]} names such as "l7" @returns {number[]} distinct slots */
export function slotsOfNames(names) {
  const slots = names.map((name) => slotOfShortName(String(name).trim())).filter((slot) => slot >= 0 && slot < kSlots);
  return [...new Set(slots)];
}

/** @param {Moment} moment @returns {string} "#t=..." */
export function formatHash(moment) {
  const parts = [`t=${moment.time}${moment.stopped > 0 ? `+${moment.stopped}` : ''}`];
  if (moment.selected && moment.selected.length > 0) parts.push(`p=${moment.selected.map(shortNameOfSlot).join(',')}`);
  if (moment.speed !== null && moment.speed !== 1) parts.push(`s=${moment.speed}`);
  if (moment.view && moment.view.zoom > 1) {
    const {zoom, x, y} = moment.view;
    parts.push(`z=${Number(zoom.toFixed(2))},${Number(x.toFixed(1))},${Number(y.toFixed(1))}`);
  }
  if (moment.follow !== '') parts.push(`f=${moment.follow}`);
  if (moment.debugging) parts.push('d=1');
  if (moment.play) parts.push('play=1');
  return `#${parts.join('&')}`;
}
