// The program of replay pages that the page saves.
import '../../../viewer/web/src/team_drawings.js';
import '../../../viewer/web/src/main.js';
