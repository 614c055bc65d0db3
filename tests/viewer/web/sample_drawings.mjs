// A debug log of a team in the sample match: texts and shapes of two players, one while the clock stands.
export const kShownFrame = 50;
export const kStoppedTime = 100;

export function sampleDebugLog(text = 'pass to 9') {
  const lines = [
    {t: kShownFrame, unum: 7, kind: 'text', level: 'TEAM', message: text},
    {t: kShownFrame, unum: 7, kind: 'circle', level: 'SHOOT', center: {x: 10, y: 5}, radius: 3, color: '#ff0000', fill: true},
    {t: kShownFrame, unum: 9, kind: 'message', level: 'ACTION_CHAIN', position: {x: 1}, message: 'run here', color: 'white'},
    {t: kStoppedTime, stopped: 7, unum: 9, kind: 'rectangle', level: 'TEAM', left: 1, top: 2, length: 3, width: 4},
    {t: 200, unum: 9, kind: 'debug_client', message: 'late'},
    {kind: 'omitted', count: 12},
  ];
  return lines.map((line) => `${JSON.stringify(line)}\n`).join('');
}
