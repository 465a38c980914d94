/** Writes files into an uncompressed zip archive: programs are short, and libraries are already compressed. */

const TABLE = Uint32Array.from({ length: 256 }, (_, number) => {
  let value = number;
  for (let i = 0; i < 8; i += 1) {
    value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  }
  return value;
});

/** @param {Uint8Array} bytes */
function checksum(bytes) {
  let value = 0xffffffff;
  for (const byte of bytes) {
    value = TABLE[(value ^ byte) & 255] ^ (value >>> 8);
  }
  return (value ^ 0xffffffff) >>> 0;
}

const MADE_ON_UNIX = 0x0314; // makes unzip apply file modes
const MODE = 0o100644;
const MODE_OF_SCRIPTS = 0o100755;
const NAMES_ARE_UTF8 = 0x0800;
const DATE = 0x21; // the earliest date of the format

/** @param {number[]} fields pairs of byte count and value @returns {Uint8Array<ArrayBuffer>} */
function header(...fields) {
  const bytes = [];
  for (let i = 0; i < fields.length; i += 2) {
    for (let byte = 0; byte < fields[i]; byte += 1) {
      bytes.push((fields[i + 1] >>> (8 * byte)) & 255);
    }
  }
  return Uint8Array.from(bytes);
}

/** @param {Map<string, string | Uint8Array>} files text or bytes of each file by path @returns {Blob} */
export function zip(files) {
  const parts = [];
  const directory = [];
  let offset = 0;
  for (const [path, inside] of files) {
    const name = new TextEncoder().encode(path);
    const content = typeof inside === 'string' ? new TextEncoder().encode(inside) : inside;
    const isScript = typeof inside === 'string' && inside.startsWith('#!');
    const mode = (isScript ? MODE_OF_SCRIPTS : MODE) * 0x10000;
    const about = [2, 20, 2, NAMES_ARE_UTF8, 2, 0, 2, 0, 2, DATE, 4, checksum(content)];
    const sizes = [4, content.length, 4, content.length, 2, name.length, 2, 0];
    const local = header(4, 0x04034b50, ...about, ...sizes);
    parts.push(local, name, content);
    const place = [2, 0, 2, 0, 2, 0, 4, mode, 4, offset];
    directory.push(header(4, 0x02014b50, 2, MADE_ON_UNIX, ...about, ...sizes, ...place), name);
    offset += local.length + name.length + content.length;
  }
  const length = directory.reduce((sum, part) => sum + part.length, 0);
  const end = header(4, 0x06054b50, 2, 0, 2, 0, 2, files.size, 2, files.size, 4, length, 4, offset, 2, 0);
  return new Blob(/** @type {BlobPart[]} */ ([...parts, ...directory, end]), { type: 'application/zip' });
}
