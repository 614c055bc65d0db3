// The decision debugger, in pages with recorded decisions.
import {DecisionStore} from './decision_store.js';
import {readDecisions, sidesWithDecisions} from './decision_data.js';
import {kExtensions} from './extensions.js';
import {drawDecision} from './layer_considered.js';
import {DecisionPanel} from './panel_decision.js';

kExtensions.decisions = {
  makeStore(record) {
    return new DecisionStore(record, sidesWithDecisions(), readDecisions);
  },
  makePanel(viewer) {
    return new DecisionPanel(viewer);
  },
  draw: drawDecision,
};
