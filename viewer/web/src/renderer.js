// Draws the field: pitch from a cache, then the layers.
import {kExtensions} from './extensions.js';
import {Pose, poseAt} from './interpolate.js';
import {drawAreas} from './layer_areas.js';
import {drawBall} from './layer_ball.js';
import {drawChoices} from './layer_choices.js';
import {drawOffsideLines} from './layer_offside.js';
import {drawPlayers} from './layer_players.js';
import {drawTrails} from './layer_trails.js';
import {drawView} from './layer_view.js';
import {drawPitch} from './pitch.js';

/** Marks of one frame stay visible this long. */
const kMarkMs = 150;

export class Renderer {
  /** @param {HTMLCanvasElement} canvas @param {import('./record.js').MatchRecord} record @param {import('./camera.js').Camera} camera */
  constructor(canvas, record, camera) {
    this.canvas = canvas;
    this.record = record;
    this.camera = camera;
    this.pose = new Pose();
    this.ratio = 1;
    this.pitch = document.createElement('canvas');
    this.pitchKey = '';
  }

  /** @param {number} width @param {number} height in CSS pixels @param {number} ratio device pixels per CSS pixel */
  resize(width, height, ratio) {
    this.ratio = ratio;
    this.canvas.width = Math.max(1, Math.round(width * ratio));
    this.canvas.height = Math.max(1, Math.round(height * ratio));
    this.camera.resize(width, height);
  }

  /** @param {{at: number, playing: boolean, framesPerSecond: number}} clock
   * @param {{theme: import('./theme.js').Theme, layers: import('./settings.js').Layers, selected: number[], smooth: boolean,
   * track?: import('./decision_track.js').DecisionTrack | null, drawings?: import('./drawing_store.js').Shown[]}} view */
  draw(clock, view) {
    poseAt(this.record, clock.at, this.pose, view.smooth);
    this.#follow(view.selected);
    const context = this.canvas.getContext('2d', {alpha: false});
    this.#drawPitch(context, view.theme);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    const markFrames = clock.playing ? Math.max(1, Math.ceil((clock.framesPerSecond * kMarkMs) / 1000)) : 1;
    const scene = {context, record: this.record, pose: this.pose, camera: this.camera, theme: view.theme, layers: view.layers, selected: view.selected, markFrames, track: view.track, drawings: view.drawings};
    drawOffsideLines(scene);
    drawView(scene);
    drawAreas(scene);
    drawTrails(scene);
    drawPlayers(scene);
    drawBall(scene);
    drawChoices(scene);
    kExtensions.drawings?.draw(scene);
    kExtensions.decisions?.draw(scene);
  }

  #follow(selected) {
    const {camera, pose} = this;
    if (camera.follow === 'ball') camera.center(pose.ballX, pose.ballY);
    if (camera.follow === 'player' && selected.length > 0) camera.center(pose.x[selected[0]], pose.y[selected[0]]);
  }

  #drawPitch(context, theme) {
    const {camera, canvas, ratio, pitch} = this;
    const key = [canvas.width, canvas.height, ratio, camera.scale, camera.x, camera.y, theme.grass].join(' ');
    if (key !== this.pitchKey) {
      this.pitchKey = key;
      pitch.width = canvas.width;
      pitch.height = canvas.height;
      const pitchContext = pitch.getContext('2d', {alpha: false});
      pitchContext.setTransform(ratio, 0, 0, ratio, 0, 0);
      drawPitch(pitchContext, camera, theme, this.record.parameter('goal_width', 14.02));
    }
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(pitch, 0, 0);
  }
}
