// The program of replay pages with recorded decisions.
import '../../../viewer/web/src/decision_debugger.js';
import './replay.js';
