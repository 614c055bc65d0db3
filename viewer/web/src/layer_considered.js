// The decision of a player: its estimates, and where what it considered would have led: a line to each target, those of a policy with probabilities.
import {drawChoiceLabel, drawChoicePath} from './layer_choices.js';
import {drawEstimates} from './layer_estimates.js';
import {sideOfSlot} from './sides.js';

/** Options of a policy with less have no line, in percent. */
const kLeastShare = 1;
/** Options of a policy with less have no label, in percent. */
const kLeastLabel = 5;

/** @param {import('./scene.js').Scene} scene */
export function drawDecision(scene) {
  drawEstimates(scene);
  drawConsidered(scene);
}

function drawConsidered(scene) {
  const {track, pose, context} = scene;
  const decision = track ? track.at(pose.frame) : -1;
  if (!track || decision < 0) return;
  const from = track.selfRow(decision)?.estimated;
  if (!from) return;
  const direction = sideOfSlot(track.slot) === 'left' ? 1 : -1;
  const drawn = track.considered(decision).filter(({chosen, target, isShare, value}) => target && (chosen || !isShare || value >= kLeastShare));
  context.save();
  for (const {chosen, target, isShare, value} of drawn.sort((a, b) => Number(a.chosen) - Number(b.chosen) || a.value - b.value)) {
    const to = target.map((coordinate) => direction * coordinate);
    drawChoicePath(scene, track, from, to, chosen);
    if (isShare && (chosen || value >= kLeastLabel)) drawChoiceLabel(scene, to, `${Math.round(value)} %`);
  }
  context.restore();
}
