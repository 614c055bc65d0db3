// What teams print. A team that prints without end fills no memory: the rest is counted.
const kMostLines = 400;
const kLongestLine = 400;

/** Replaces the console of this worker. @param {() => string} sideNow who prints @returns {{take: () => object[]}} */
export function captureConsole(sideNow) {
  let lines = [];
  let room = kMostLines;
  let left = 0; // lines without room

  const add = (level, values) => {
    if (room === 0) {
      left += 1;
      return;
    }
    room -= 1;
    lines.push({ level, side: sideNow(), text: values.map(textOf).join(' ').slice(0, kLongestLine) });
  };

  const captured = {};
  for (const level of ['log', 'info', 'debug', 'warn', 'error']) captured[level] = (...values) => add(level, values);
  for (const name of Object.keys(console)) captured[name] ??= () => {};
  Object.defineProperty(globalThis, 'console', { value: captured });

  return {
    take() {
      const taken = lines;
      if (left > 0) taken.push({ level: 'warn', side: '', text: `and ${left} lines more`, more: true });
      lines = [];
      left = 0;
      return taken;
    },
  };
}

function textOf(value) {
  if (typeof value === 'string') return value;
  if (value instanceof Error) return `${value}`;
  try {
    return JSON.stringify(value) ?? String(value);
  } catch {
    return String(value);
  }
}
