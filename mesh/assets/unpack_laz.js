// Writes the points of a LAZ file to standard output as a LAS file, chunk by chunk, with the package
// laz-perf. The LAS file has the header without records, and its points have what clast reads of
// them: they are cut down to format 0 or 6, the latter without intensity and user data. Node runs
// this script as `node -e SCRIPT -- FILE`; threads that unpack chunks run it too. It ends with code 3
// if laz-perf is not there, and with 1 and a line on standard error if the file can't be unpacked.
'use strict';
const fs = require('fs');
const os = require('os');
const path = require('path');
const threads = require('worker_threads');

// Each takes some 20 MB.
const mostThreads = 8;

class Refusal extends Error {}

function findLazPerf() {
  const here = (folder) => require.resolve('laz-perf', {paths: [folder]});
  try {
    return here(process.cwd());
  } catch {
    try {
      const root = require('child_process').execFileSync('npm', ['root', '-g'], {
        encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'], timeout: 30000,
      });
      return here(root.trim());
    } catch {
      return null;
    }
  }
}

// Bytes of an open file. A range outside the file is refused.
class Bytes {
  constructor(name) {
    this.file = fs.openSync(name, 'r');
    this.size = fs.fstatSync(this.file).size;
  }
  read(begin, count) {
    if (begin < 0 || begin + count > this.size) {
      throw new Refusal(`it ends at byte ${this.size}, but bytes up to ${begin + count} are ` +
                        'needed; it was cut short or is corrupt');
    }
    const bytes = Buffer.alloc(count);
    for (let done = 0; done < count;) {
      const now = fs.readSync(this.file, bytes, done, count - done, begin + done);
      if (now === 0) throw new Refusal('it became shorter while it was read');
      done += now;
    }
    return bytes;
  }
}

// Size of a point record without extra bytes, by point format.
const recordSizes = {0: 20, 1: 28, 2: 26, 3: 34, 6: 30, 7: 36, 8: 38};

function readHeader(file) {
  const minor = file.read(25, 1)[0];
  const size = file.read(94, 2).readUInt16LE();
  const bytes = file.read(0, size);
  const header = {
    bytes,
    pointOffset: bytes.readUInt32LE(96),
    format: bytes[104] & 0x3F,
    recordSize: bytes.readUInt16LE(105),
    count: minor >= 4 && size >= 375 ? Number(bytes.readBigUInt64LE(247)) : bytes.readUInt32LE(107),
  };
  if (!(header.format in recordSizes)) {
    throw new Refusal(`laz-perf can't unpack LAS point format ${header.format}, only ` +
                      Object.keys(recordSizes).join(', '));
  }
  if (header.recordSize < recordSizes[header.format]) {
    throw new Refusal(`point records of ${header.recordSize} bytes are too short for point ` +
                      `format ${header.format}; it is corrupt`);
  }
  return header;
}

// Record "laszip encoded" (22204) of the header: how the points are compressed.
function readCompression(file, header) {
  let at = header.bytes.length;
  for (let left = header.bytes.readUInt32LE(100); left > 0; --left) {
    const record = file.read(at, 54);
    const size = record.readUInt16LE(20);
    at += 54;
    if (record.toString('latin1', 2, 16) === 'laszip encoded' && record.readUInt16LE(18) === 22204) {
      return checkCompression(file.read(at, size), header);
    }
    at += size;
  }
  throw new Refusal('it has no record of its compression (laszip encoded, 22204); it is corrupt');
}

// The items of a point have version 2 up to point format 5 and version 3 from 6 on.
function checkCompression(record, header) {
  const compressor = record.readUInt16LE(0), coder = record.readUInt16LE(2);
  const layered = header.format >= 6;
  if (coder !== 0 || compressor !== (layered ? 3 : 2)) {
    throw new Refusal(`laz-perf can't unpack compressor ${compressor}, coder ${coder}`);
  }
  let size = 0;
  for (let item = 0; item < record.readUInt16LE(32); ++item) {
    const version = record.readUInt16LE(38 + 6 * item);
    if (version !== (layered ? 3 : 2)) {
      throw new Refusal(`laz-perf can't unpack version ${version} of item ` +
                        record.readUInt16LE(34 + 6 * item));
    }
    size += record.readUInt16LE(36 + 6 * item);
  }
  if (size !== header.recordSize) {
    throw new Refusal(`its compressed points have ${size} bytes, its header says ` +
                      `${header.recordSize}; it is corrupt`);
  }
  return {chunkSize: record.readUInt32LE(12)};
}

const minLength = 2 ** 24, maxLength = 2 ** 32 - 1;

// Adaptive model of the frequencies of symbols.
class SymbolModel {
  constructor(symbols) {
    this.counts = new Array(symbols).fill(1);
    this.total = 0;
    this.cycle = symbols;
    this.update();
    this.left = this.cycle = (symbols + 6) >> 1;
  }
  update() {
    this.total += this.cycle;
    if (this.total > 2 ** 15) {
      this.counts = this.counts.map((count) => (count + 1) >> 1);
      this.total = this.counts.reduce((sum, count) => sum + count, 0);
    }
    const scale = Math.floor(2 ** 31 / this.total);
    let sum = 0;
    this.begins = this.counts.map((count) => {
      const begin = Math.floor(scale * sum / 2 ** 16);
      sum += count;
      return begin;
    });
    this.cycle = Math.min(Math.floor(5 * this.cycle / 4), (this.counts.length + 6) << 3);
    this.left = this.cycle;
  }
  count(symbol) {
    ++this.counts[symbol];
    if (--this.left === 0) this.update();
  }
}

// Arithmetic decoder of A. Said: https://www.hpl.hp.com/techreports/2004/HPL-2004-76.html
class Decoder {
  constructor(bytes) {
    this.bytes = bytes;
    this.at = 0;
    this.value = 0;
    for (let i = 0; i < 4; ++i) this.value = this.value * 256 + this.next();
    this.length = maxLength;
  }
  next() {
    return this.at < this.bytes.length ? this.bytes[this.at++] : 0;
  }
  narrow(begin, length) {
    this.value -= begin;
    this.length = length;
    while (this.length < minLength) {
      this.value = this.value * 256 + this.next();
      this.length *= 256;
    }
  }
  symbol(model) {
    const unit = Math.floor(this.length / 2 ** 15);
    let symbol = model.begins.length - 1;
    while (model.begins[symbol] * unit > this.value) --symbol;
    const begin = model.begins[symbol] * unit;
    const last = symbol + 1 === model.begins.length;
    this.narrow(begin, (last ? this.length : model.begins[symbol + 1] * unit) - begin);
    model.count(symbol);
    return symbol;
  }
  bits(count) {
    if (count > 19) {
      const low = this.bits(16);
      return this.bits(count - 16) * 2 ** 16 + low;
    }
    const unit = Math.floor(this.length / 2 ** count);
    const number = Math.floor(this.value / unit);
    this.narrow(number * unit, unit);
    return number;
  }
}

// Adaptive model of a bit.
class BitModel {
  constructor() {
    this.zeros = 1;
    this.total = 2;
    this.probability = 2 ** 12;
    this.left = this.cycle = 4;
  }
  decode(decoder) {
    const begin = this.probability * Math.floor(decoder.length / 2 ** 13);
    const bit = decoder.value >= begin ? 1 : 0;
    if (bit) decoder.narrow(begin, decoder.length - begin);
    else {
      decoder.narrow(0, begin);
      ++this.zeros;
    }
    if (--this.left === 0) this.update();
    return bit;
  }
  update() {
    this.total += this.cycle;
    if (this.total > 2 ** 13) {
      this.total = (this.total + 1) >> 1;
      this.zeros = (this.zeros + 1) >> 1;
      if (this.zeros === this.total) ++this.total;
    }
    this.probability = Math.floor(this.zeros * Math.floor(2 ** 31 / this.total) / 2 ** 18);
    this.left = this.cycle = Math.min(Math.floor(5 * this.cycle / 4), 64);
  }
}

// Whole numbers of 32 bits, coded as differences to predictions.
class Integers {
  constructor(contexts) {
    this.widths = Array.from({length: contexts}, () => new SymbolModel(33));
    this.single = new BitModel();
    this.correctors = Array.from({length: 32}, (_, k) => new SymbolModel(2 ** Math.min(k + 1, 8)));
  }
  decode(decoder, prediction, context) {
    return (prediction + this.difference(decoder, context)) >>> 0;
  }
  difference(decoder, context) {
    const width = decoder.symbol(this.widths[context]);
    if (width === 0) return this.single.decode(decoder);
    if (width === 32) return -(2 ** 31);
    let number = decoder.symbol(this.correctors[width - 1]);
    if (width > 8) number = number * 2 ** (width - 8) + decoder.bits(width - 8);
    return number >= 2 ** (width - 1) ? number + 1 : number - (2 ** width - 1);
  }
}

// Chunks in order: where each begins, its bytes and its points.
function readChunks(file, header, {chunkSize}) {
  const position = Number(file.read(header.pointOffset, 8).readBigInt64LE());
  // A program that wrote to a pipe put the position at the end.
  const begin = position === -1 ? Number(file.read(file.size - 8, 8).readBigInt64LE()) : position;
  const head = file.read(begin, 8);
  const count = head.readUInt32LE(4);
  if (head.readUInt32LE(0) !== 0) throw new Refusal('the version of its chunk table is unknown');
  if (count > begin) throw new Refusal('its chunk table is corrupt');
  const decoder = new Decoder(file.read(begin + 8, Math.min(file.size - begin - 8, 16 * count + 16)));
  const integers = new Integers(2);
  const varying = chunkSize === maxLength;
  const chunks = [];
  let at = header.pointOffset + 8, points = 0, bytes = 0, left = header.count;
  for (let i = 0; i < count && left > 0; ++i) {
    points = varying ? integers.decode(decoder, points, 0) : Math.min(chunkSize, left);
    bytes = integers.decode(decoder, bytes, 1);
    if (at + bytes > begin || points > left) throw new Refusal('its chunk table is corrupt');
    chunks.push({at, bytes, points});
    at += bytes;
    left -= points;
  }
  if (left > 0) {
    throw new Refusal(`its chunks hold ${header.count - left} of the ${header.count} points that ` +
                      'its header says; it was cut short or is corrupt');
  }
  return chunks;
}

// Point format to which a format is cut down; its fields come first in the record.
const plainFormat = (format) => format < 6 ? 0 : 6;

// Header without records before and after the points.
function plainHeader(header) {
  const bytes = Buffer.from(header.bytes), format = plainFormat(header.format);
  bytes.writeUInt32LE(bytes.length, 96);
  bytes.writeUInt32LE(0, 100);
  bytes[104] = format;
  bytes.writeUInt16LE(recordSizes[format], 105);
  if (bytes.length >= 375) bytes.fill(0, 235, 247);
  return bytes;
}

// Starts laz-perf and returns it with `next(decoder, to)`, which writes the next point of a chunk to
// memory. `decoder.getPoint(to)` does the same, but the checks of its types take a quarter of all
// time. So the function below it is noted when laz-perf declares it to its class (Emscripten's
// embind); if that can't be seen, `getPoint` is used.
async function startLazPerf({found, compiled}) {
  let memory, table, decoderType;
  const getPoint = new Map();
  const textAt = (at) => {
    const bytes = Buffer.from(memory.buffer);
    return bytes.toString('latin1', at, bytes.indexOf(0, at));
  };
  const noted = {
    __embind_register_class: (words) => {
      if (textAt(words[10]) === 'ChunkDecoder') decoderType = words[0];
    },
    __embind_register_class_function: (words) => {
      if (textAt(words[1]) === 'getPoint') getPoint.set(words[0], [words[5], words[6]]);
    },
  };
  const lazPerf = await require(found).createLazPerf({
    instantiateWasm(imports, receive) {
      for (const functions of Object.values(imports)) {
        for (const [key, declare] of Object.entries(functions)) {
          const note = noted[declare.name];
          if (note) functions[key] = (...words) => (note(words), declare(...words));
        }
      }
      const instance = new WebAssembly.Instance(compiled, imports);
      for (const part of Object.values(instance.exports)) {
        if (part instanceof WebAssembly.Memory) memory = part;
        if (part instanceof WebAssembly.Table) table = part;
      }
      receive(instance, compiled);
      return instance.exports;
    },
  });
  if (!getPoint.has(decoderType)) return {lazPerf, next: (decoder, to) => decoder.getPoint(to)};
  const [at, context] = getPoint.get(decoderType);
  const invoke = table.get(at);
  return {lazPerf, next: (decoder, to) => invoke(context, decoder.$$.ptr, to)};
}

// Drops the layers of intensity and user data from a chunk of point formats 6 to 8: clast does not
// read them, and laz-perf then gives all points the values of the first.
function dropLayers(bytes, {format, recordSize}) {
  if (format < 6) return bytes;
  const intensity = 4, userData = 6;
  const sizes = recordSize + 4;  // after the first point and the number of points
  const layers = 9 + format - 6 + recordSize - recordSizes[format];
  let at = sizes + 4 * layers;
  const parts = [bytes.subarray(0, at)];
  for (let layer = 0; layer < layers; ++layer) {
    const size = bytes.readUInt32LE(sizes + 4 * layer);
    if (layer === intensity || layer === userData) bytes.writeUInt32LE(0, sizes + 4 * layer);
    else parts.push(bytes.subarray(at, at + size));
    at += size;
  }
  if (at > bytes.length) throw new Refusal('its layers are longer than the chunk');
  return Buffer.concat(parts);
}

// Unpacks a chunk. Each point overwrites what the one before has beyond the plain format.
function unpackChunk({lazPerf, next}, file, header, chunk) {
  const {format, recordSize} = header;
  const step = recordSizes[plainFormat(format)], size = chunk.points * step;
  const packed = dropLayers(file.read(chunk.at, chunk.bytes), header);
  const input = lazPerf._malloc(packed.length), output = lazPerf._malloc(size + recordSize);
  if (input === 0 || output === 0) throw new Error('it does not fit into memory');
  lazPerf.HEAPU8.set(packed, input);
  const decoder = new lazPerf.ChunkDecoder();
  decoder.open(format, recordSize, input);
  for (let to = output, end = output + size; to < end; to += step) next(decoder, to);
  decoder.delete();
  const points = lazPerf.HEAPU8.slice(output, output + size);
  lazPerf._free(input);
  lazPerf._free(output);
  return points;
}

// A thread: unpacks the chunks that it is sent.
async function runThread({name, header, program}) {
  const file = new Bytes(name);
  const started = startLazPerf(program);
  threads.parentPort.on('message', async (chunk) => {
    let points = null;
    try {
      points = unpackChunk(await started, file, header, chunk);
    } catch {}
    threads.parentPort.postMessage(points, points ? [points.buffer] : []);
  });
}

// Unpacks chunks in threads, a few ahead, and yields their points in order.
async function* unpackChunks(chunks, workerData) {
  const script = process.execArgv[process.execArgv.indexOf('-e') + 1];
  const cores = os.availableParallelism ? os.availableParallelism() : os.cpus().length;
  const count = Math.min(cores, mostThreads, chunks.length);
  const workers = Array.from({length: count}, () => {
    const worker = new threads.Worker(script, {eval: true, workerData});
    worker.asked = [];
    worker.on('message', (points) => worker.asked.shift()(points));
    worker.on('error', stop);
    return worker;
  });
  const ask = (worker, chunk) => new Promise((resolve) => {
    worker.asked.push(resolve);
    worker.postMessage(chunk);
  });
  const ahead = 3 * count, asked = [];
  for (let i = 0; i < chunks.length + ahead; ++i) {
    if (i < chunks.length) asked.push(ask(workers[i % count], chunks[i]));
    if (i < ahead || asked.length === 0) continue;
    const points = await asked.shift();
    if (points === null) {
      throw new Refusal(`its chunk at byte ${chunks[i - ahead].at} can't be unpacked; it is corrupt`);
    }
    yield points;
  }
}

async function unpack(name) {
  const found = findLazPerf();
  if (found === null) process.exit(3);
  const file = new Bytes(name);
  const header = readHeader(file);
  const chunks = readChunks(file, header, readCompression(file, header));
  const compiled = new WebAssembly.Module(
      fs.readFileSync(path.join(path.dirname(found), 'laz-perf.wasm')));
  const write = (bytes) => new Promise((done) => process.stdout.write(bytes, done));
  await write(plainHeader(header));
  for await (const points of unpackChunks(chunks, {name, header, program: {found, compiled}})) {
    await write(points);
  }
  process.exit(0);
}

function stop(error) {
  console.error(error instanceof Refusal ? error.message : String(error));
  process.exit(1);
}

if (threads.isMainThread) unpack(process.argv[process.argv.length - 1]).catch(stop);
else runThread(threads.workerData);
