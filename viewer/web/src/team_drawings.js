// Texts and drawings of Playmakers, in pages that may have some.
import {followDrawings, readDrawings} from './drawing_data.js';
import {DrawingStore} from './drawing_store.js';
import {DrawingFilter} from './drawings.js';
import {kExtensions} from './extensions.js';
import {drawDrawings} from './layer_drawings.js';
import {PlaymakerPanel} from './panel_playmaker.js';

kExtensions.drawings = {
  makeStore(record) {
    return new DrawingStore(record, new DrawingFilter());
  },
  makePanel(viewer) {
    return new PlaymakerPanel(viewer);
  },
  read(path, store, onChange, prefix = '') {
    return path === '' ? readDrawings(store, onChange, prefix) : followDrawings(path, store, onChange);
  },
  draw: drawDrawings,
};
