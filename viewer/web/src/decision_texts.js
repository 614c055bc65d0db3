// Texts of decisions: those of a player differ in little more than their numbers (docs/formats/decisions.md).

const kShapeText = new TextDecoder();
const kNumberPlace = '\x01';
/** Thousandths in the last digit, by number of decimals. */
const kUnits = [1000, 100, 10, 1];

/** @param {number} thousandths @param {number} decimals @returns {string} "-12.5" */
function numberText(thousandths, decimals) {
  return (thousandths / 1000).toFixed(decimals);
}

/** The shapes that texts of one kind of one player had so far, and the last numbers at their places. */
export class TextShapes {
  constructor() {
    /** Texts between the numbers. @type {string[][]} */
    this.shapes = [];
    /** By shape and place, in thousandths. @type {number[][]} */
    this.last = [];
  }

  /** @param {import('./varint.js').ByteReader} reader @param {number} count @returns {string[]} */
  read(reader, count) {
    for (let fresh = reader.varint(); fresh > 0; --fresh) this.#add(kShapeText.decode(reader.take(reader.varint())));
    const ids = Array.from({length: count}, () => reader.varint());
    const textsOf = new Map();
    ids.forEach((id, text) => textsOf.get(id)?.push(text) ?? textsOf.set(id, [text]));
    /** @type {string[][]} */
    const numbers = ids.map(() => []);
    for (const id of [...textsOf.keys()].sort((a, b) => a - b)) {
      if (id >= this.shapes.length) throw new Error('the decisions in this page are corrupt');
      for (let place = 0; place < this.last[id].length; ++place) {
        for (const text of textsOf.get(id)) numbers[text].push(this.#number(reader, id, place));
      }
    }
    return ids.map((id, text) => this.shapes[id].map((piece, i) => (i === 0 ? piece : numbers[text][i - 1] + piece)).join(''));
  }

  #add(shape) {
    const pieces = shape.split(kNumberPlace);
    this.shapes.push(pieces);
    this.last.push(new Array(pieces.length - 1).fill(0));
  }

  #number(reader, id, place) {
    const code = reader.varint();
    const decimals = code % 4;
    const unit = kUnits[decimals];
    const zigzag = Math.floor(code / 4);
    const step = zigzag % 2 === 0 ? zigzag / 2 : -(zigzag + 1) / 2;
    const expected = Math.floor((2 * this.last[id][place] + unit) / (2 * unit));
    this.last[id][place] = (expected + step) * unit;
    return numberText(this.last[id][place], decimals);
  }
}
