// A clip of the field, as a video file that the browser saves.
import {saveFile} from './export.js';
import {cycleLabel} from './record.js';

const kPicturesPerSecond = 60;
const kTypes = ['video/webm;codecs=vp9', 'video/webm;codecs=vp8', 'video/webm'];

/** Records while the match plays: from start() until it rests or stop() is called. */
export class Clip {
  /** @param {import('./viewer.js').Viewer} viewer @param {HTMLCanvasElement} canvas */
  constructor(viewer, canvas) {
    this.viewer = viewer;
    this.canvas = canvas;
    /** @type {MediaRecorder | null} */
    this.recorder = null;
  }

  toggle() {
    if (this.recorder) this.#stop();
    else this.#start();
  }

  /** Ends the clip where the match rests. */
  followClock() {
    if (this.recorder && !this.viewer.clock.playing) this.#stop();
  }

  #start() {
    const {viewer, canvas} = this;
    const type = typeof MediaRecorder === 'undefined' || !canvas.captureStream ? undefined : kTypes.find((each) => MediaRecorder.isTypeSupported(each));
    if (!type) return viewer.say('This browser cannot record a clip');
    const pieces = [];
    const recorder = new MediaRecorder(canvas.captureStream(kPicturesPerSecond), {mimeType: type});
    const first = cycleLabel(viewer.record, viewer.frame);
    recorder.ondataavailable = ({data}) => pieces.push(data);
    recorder.onstop = () => {
      const name = `cycles-${first}-to-${cycleLabel(viewer.record, viewer.frame)}.webm`.replaceAll('+', '-');
      saveFile(new Blob(pieces, {type: 'video/webm'}), name);
      viewer.say('Clip saved');
    };
    recorder.start();
    this.recorder = recorder;
    viewer.recording = true;
    if (!viewer.clock.playing) viewer.clock.play();
    viewer.say('Recording a clip');
    viewer.changed('moment');
  }

  #stop() {
    const {recorder, viewer} = this;
    this.recorder = null;
    viewer.recording = false;
    recorder?.stop();
    for (const track of recorder?.stream.getTracks() ?? []) track.stop();
    viewer.changed('moment');
  }
}
