// The messages of the wire as plain objects: the field names of proto/playmaker.proto, enums as their
// names, unset messages null, lists and maps never missing, and the name of the field that a oneof has.
// These are the objects of the projects of `cls new javascript`.

const VARINT = 0;
const FIXED64 = 1;
const BYTES = 2;
const FIXED32 = 5;

const SCALARS = {
  bool: { wire: VARINT, zero: false, read: (input) => input.varint() !== 0, write: (out, value) => out.varint(value ? 1 : 0) },
  int32: { wire: VARINT, zero: 0, read: (input) => input.varint(), write: (out, value) => out.varint(Math.trunc(value)) },
  double: { wire: FIXED64, zero: 0, read: (input) => input.double(), write: (out, value) => out.double(value) },
  float: { wire: FIXED32, zero: 0, read: (input) => input.float(), write: (out, value) => out.float(value) },
  string: { wire: BYTES, zero: '', read: (input) => input.string(), write: (out, value) => out.string(`${value}`) },
};

/** Encodes and decodes the messages of a schema: {messages: {NAME: [field]}, enums: {NAME: {VALUE: number}}}. */
export class Messages {
  #types = new Map();

  constructor(schema) {
    const enums = Object.fromEntries(Object.entries(schema.enums)
      .map(([name, values]) => [name, enumeration(values)]));
    for (const [name, fields] of Object.entries(schema.messages)) {
      this.#types.set(name, { name, fields: fields.map((field) => ({ ...field })) });
    }
    for (const type of this.#types.values()) {
      for (const field of type.fields) {
        field.message = field.type === 'message' ? this.#types.get(field.of) : null;
        field.scalar = field.type === 'enum' ? enums[field.of] : SCALARS[field.type];
      }
      type.byNumber = new Map(type.fields.map((field) => [field.number, field]));
    }
    // The value of a map is a field of its entry.
    for (const type of this.#types.values()) {
      for (const field of type.fields) {
        if (field.map) [field.key, field.value] = [1, 2].map((number) => field.message.byNumber.get(number));
      }
    }
  }

  /** The object of a message. */
  decode(name, bytes) {
    return decode(this.#types.get(name), Input.of(bytes));
  }

  /** The bytes of a message. A TypeError names a field that is not an object or a list. */
  encode(name, object) {
    const out = new Output();
    encode(this.#types.get(name), object ?? {}, name, out);
    return out.take();
  }
}

function enumeration(values) {
  const names = new Map(Object.entries(values).map(([name, number]) => [number, name]));
  return {
    wire: VARINT,
    zero: names.get(0),
    read: (input) => {
      const number = input.varint();
      return names.get(number) ?? number;
    },
    write: (out, value) => out.varint(typeof value === 'number' ? value : values[value] ?? 0),
  };
}

function empty(type) {
  const object = {};
  for (const field of type.fields) {
    if (field.map) object[field.name] = {};
    else if (field.repeated) object[field.name] = [];
    else if (!field.oneof) object[field.name] = field.message ? null : field.scalar.zero;
  }
  return object;
}

function decode(type, input) {
  const object = empty(type);
  while (!input.ended()) {
    const tag = input.varint();
    const field = type.byNumber.get(tag >>> 3);
    if (!field) input.skip(tag & 7);
    else if (field.map) decodeEntry(field, input, object[field.name]);
    else if (field.repeated) decodeElements(field, tag & 7, input, object[field.name]);
    else {
      object[field.name] = decodeValue(field, input);
      if (field.oneof) object[field.oneof] = field.name;
    }
  }
  return object;
}

function decodeValue(field, input) {
  return field.message ? decode(field.message, input.part()) : field.scalar.read(input);
}

function decodeElements(field, wire, input, elements) {
  if (field.message || wire !== BYTES || field.scalar.wire === BYTES) {
    elements.push(decodeValue(field, input));
    return;
  }
  const packed = input.part();
  while (!packed.ended()) elements.push(field.scalar.read(packed));
}

function decodeEntry(field, input, entries) {
  const entry = decode(field.message, input.part());
  entries[entry.key] = entry.value ?? (field.value.message ? empty(field.value.message) : entry.value);
}

function encode(type, object, place, out) {
  for (const field of type.fields) {
    const value = object[field.name];
    if (value === undefined || value === null) continue;
    const where = `${place}.${field.name}`;
    if (field.map) encodeEntries(field, value, where, out);
    else if (field.repeated) encodeElements(field, value, where, out);
    else encodeValue(field, value, where, out);
  }
}

function encodeValue(field, value, where, out) {
  if (!field.message) {
    out.varint(field.number * 8 + field.scalar.wire);
    field.scalar.write(out, value);
    return;
  }
  if (typeof value !== 'object') throw new TypeError(`${where}: object expected`);
  out.varint(field.number * 8 + BYTES);
  const begin = out.beginPart();
  encode(field.message, value, where, out);
  out.endPart(begin);
}

function encodeElements(field, value, where, out) {
  if (!Array.isArray(value)) throw new TypeError(`${where}: array expected`);
  value.forEach((element, index) => encodeValue(field, element, `${where}[${index}]`, out));
}

function encodeEntries(field, value, where, out) {
  if (typeof value !== 'object') throw new TypeError(`${where}: object expected`);
  for (const [key, element] of Object.entries(value)) {
    out.varint(field.number * 8 + BYTES);
    const begin = out.beginPart();
    encodeValue(field.key, Number(key), where, out);
    encodeValue(field.value, element, `${where}.${key}`, out);
    out.endPart(begin);
  }
}

const decoder = new TextDecoder();
const encoder = new TextEncoder();

/** Reads the wire format. */
class Input {
  constructor(bytes, view, begin, end) {
    this.bytes = bytes;
    this.view = view;
    this.at = begin;
    this.end = end;
  }

  static of(bytes) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    return new Input(bytes, view, 0, bytes.length);
  }

  ended() {
    return this.at >= this.end;
  }

  /** The low 32 bits, signed: no message has larger integers. */
  varint() {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = this.bytes[this.at++];
      if (shift < 32) value |= (byte & 127) << shift;
      if (byte < 128) return value;
    }
  }

  double() {
    this.at += 8;
    return this.view.getFloat64(this.at - 8, true);
  }

  float() {
    this.at += 4;
    return this.view.getFloat32(this.at - 4, true);
  }

  /** The bytes of a message or of a packed list. */
  part() {
    const size = this.varint();
    this.at += size;
    return new Input(this.bytes, this.view, this.at - size, this.at);
  }

  string() {
    const size = this.varint();
    this.at += size;
    // Most strings are short names, for which a decoder is slow.
    let text = '';
    for (let i = this.at - size; i < this.at; ++i) {
      if (this.bytes[i] > 127) return decoder.decode(this.bytes.subarray(this.at - size, this.at));
      text += String.fromCharCode(this.bytes[i]);
    }
    return text;
  }

  skip(wire) {
    if (wire === VARINT) this.varint();
    else if (wire === FIXED64) this.at += 8;
    else if (wire === FIXED32) this.at += 4;
    else if (wire === BYTES) this.part();
    else throw new Error(`unknown kind of field: ${wire}`);
  }
}

/** Writes the wire format. */
class Output {
  constructor() {
    this.bytes = new Uint8Array(512);
    this.view = new DataView(this.bytes.buffer);
    this.size = 0;
  }

  take() {
    return this.bytes.subarray(0, this.size);
  }

  reserve(size) {
    if (this.size + size <= this.bytes.length) return;
    const larger = new Uint8Array(2 * (this.size + size));
    larger.set(this.bytes.subarray(0, this.size));
    this.bytes = larger;
    this.view = new DataView(larger.buffer);
  }

  /** Negative numbers as 64 bits with sign, as the wire wants. */
  varint(value) {
    this.reserve(10);
    let low = value >>> 0;
    let high = value < 0 ? 0xffffffff : 0;
    while (high !== 0 || low > 127) {
      this.bytes[this.size++] = (low & 127) | 128;
      low = ((low >>> 7) | (high << 25)) >>> 0;
      high >>>= 7;
    }
    this.bytes[this.size++] = low;
  }

  double(value) {
    this.reserve(8);
    this.view.setFloat64(this.size, Number(value), true);
    this.size += 8;
  }

  float(value) {
    this.reserve(4);
    this.view.setFloat32(this.size, Number(value), true);
    this.size += 4;
  }

  string(value) {
    const bytes = encoder.encode(value);
    this.varint(bytes.length);
    this.reserve(bytes.length);
    this.bytes.set(bytes, this.size);
    this.size += bytes.length;
  }

  beginPart() {
    return this.size;
  }

  /** Puts the number of bytes since beginPart() before them. */
  endPart(begin) {
    const size = this.size - begin;
    const room = size < 128 ? 1 : size < 16384 ? 2 : size < 2097152 ? 3 : 4;
    this.reserve(room);
    this.bytes.copyWithin(begin + room, begin, this.size);
    const end = this.size + room;
    this.size = begin;
    this.varint(size);
    this.size = end;
  }
}
