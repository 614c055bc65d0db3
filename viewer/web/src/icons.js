// Icons of the buttons, as paths in a square of 24.

const kIconPaths = {
  play: 'M8 5v14l11-7z',
  pause: 'M7 5h4v14H7zM13 5h4v14h-4z',
  stepBack: 'M16 5v14l-9-7zM5 5h2v14H5z',
  stepForward: 'M8 5v14l9-7zM17 5h2v14h-2z',
  previous: 'M19 5v14l-7-7zM12 5v14l-7-7zM3 5h2v14H3z',
  next: 'M5 5v14l7-7zM12 5v14l7-7zM19 5h2v14h-2z',
  reverse: 'M20 6v12l-8-6zM12 6v12l-8-6z',
  star: 'M12 3l2.7 5.8 6.3.8-4.6 4.4 1.2 6.3L12 17.2 6.4 20.3l1.2-6.3L3 9.6l6.3-.8z',
  goal: 'M3 6h18v12h-2V8H5v10H3zM12 11a3 3 0 1 0 0 6 3 3 0 0 0 0-6z',
  zoomIn: 'M11 5h2v6h6v2h-6v6h-2v-6H5v-2h6z',
  zoomOut: 'M5 11h14v2H5z',
  fit: 'M4 4h6v2H6v4H4zM14 4h6v6h-2V6h-4zM4 14h2v4h4v2H4zM18 14h2v6h-6v-2h4z',
  follow: 'M12 7a5 5 0 1 0 0 10 5 5 0 0 0 0-10zm0 2a3 3 0 1 1 0 6 3 3 0 0 1 0-6zM11 2h2v4h-2zM11 18h2v4h-2zM2 11h4v2H2zM18 11h4v2h-4z',
  layers: 'M12 3l9 5-9 5-9-5zM5.2 11.8L12 15.6l6.8-3.8L21 13l-9 5-9-5z',
  panel: 'M3 5h18v14H3zm2 2v10h8V7zm10 0v10h4V7z',
  theme: 'M12 3a9 9 0 1 0 0 18zm1 2.070A7 7 0 0 1 13 18.930z',
  image: 'M4 5h16v14H4zm2 2v8l4-4 3 3 2-2 3 3V7zm9 1.5a1.5 1.5 0 1 1 0 3 1.5 1.5 0 0 1 0-3z',
  clip: 'M4 6h11v3.500l5-3v11l-5-3V18H4zm5.500 3a3 3 0 1 0 0 6 3 3 0 0 0 0-6z',
  link: 'M10.6 13.4l2.8-2.8 1.4 1.4-2.8 2.8zM8 11l-2.6 2.6a3.5 3.5 0 0 0 5 5L13 16l-1.4-1.4L9 17.2a1.5 1.5 0 0 1-2.2-2.2L9.4 12.4zM16 13l2.6-2.6a3.5 3.5 0 0 0-5-5L11 8l1.4 1.4L15 6.8A1.5 1.5 0 0 1 17.2 9l-2.6 2.6z',
  help: 'M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm-1 13h2v2h-2zm1-10a4 4 0 0 1 2 7.5c-.7.4-1 .8-1 1.5h-2c0-1.6.8-2.5 2-3.2a2 2 0 1 0-3-1.8H8a4 4 0 0 1 4-4z',
  live: 'M12 8a4 4 0 1 0 0 8 4 4 0 0 0 0-8zM5.6 4.2l1.4 1.4a9 9 0 0 0 0 12.8l-1.4 1.4a11 11 0 0 1 0-15.6zM18.4 4.2a11 11 0 0 1 0 15.6L17 18.4a9 9 0 0 0 0-12.8z',
};

const kSvg = 'http://www.w3.org/2000/svg';

/** @param {keyof typeof kIconPaths} name @returns {SVGElement} */
export function icon(name) {
  const svg = document.createElementNS(kSvg, 'svg');
  svg.setAttribute('viewBox', '0 0 24 24');
  svg.setAttribute('aria-hidden', 'true');
  svg.setAttribute('class', 'icon');
  const path = document.createElementNS(kSvg, 'path');
  path.setAttribute('d', kIconPaths[name]);
  path.setAttribute('fill-rule', 'evenodd');
  svg.append(path);
  return svg;
}
