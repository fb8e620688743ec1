// Simplifies a mesh with colours by meshoptimizer, for tests/bench/quality_of_values.sh: its JavaScript package, since
// Debian's library is too old for attributes.
//   node simplify_peer.mjs PACKAGE_FOLDER attributes|update INPUT.off OUTPUT.off FACES WEIGHT
// Prints the seconds that it took without reading and writing.
import { readFileSync, writeFileSync } from 'fs';
import { resolve } from 'path';
import { pathToFileURL } from 'url';

const [folder, method, input, output, faces, weight] = process.argv.slice(2);
const { MeshoptSimplifier } = await import(pathToFileURL(resolve(folder, 'meshopt_simplifier.js')).href);
await MeshoptSimplifier.ready;

const [head, counts, ...lines] = readFileSync(input, 'utf8').split('\n');
if (head !== 'COFF') throw new Error(`${input} has no colours`);
const [pointCount, faceCount] = counts.split(' ').map(Number);
const positions = new Float32Array(3 * pointCount), colours = new Float32Array(3 * pointCount);
for (let i = 0; i < pointCount; ++i) {
  const numbers = lines[i].split(' ').map(Number);
  positions.set(numbers.slice(0, 3), 3 * i);
  colours.set(numbers.slice(3, 6), 3 * i);
}
let indices = new Uint32Array(3 * faceCount);
for (let i = 0; i < faceCount; ++i) indices.set(lines[pointCount + i].split(' ').slice(1, 4).map(Number), 3 * i);

const begin = performance.now();
const weights = [1, 1, 1].map((x) => x * Number(weight));
if (method === 'update') {
  const [count] = MeshoptSimplifier.simplifyWithUpdate(
    indices, positions, 3, colours, 3, weights, null, 3 * faces, 1e30, []);
  indices = indices.slice(0, count);
} else {
  [indices] = MeshoptSimplifier.simplifyWithAttributes(
    indices, positions, 3, colours, 3, weights, null, 3 * faces, 1e30, []);
}
const seconds = (performance.now() - begin) / 1000;

const rows = ['COFF', `${pointCount} ${indices.length / 3} 0`];
for (let i = 0; i < pointCount; ++i)
  rows.push([...positions.slice(3 * i, 3 * i + 3), ...colours.slice(3 * i, 3 * i + 3), 1].join(' '));
for (let i = 0; i < indices.length; i += 3) rows.push(`3 ${indices[i]} ${indices[i + 1]} ${indices[i + 2]}`);
writeFileSync(output, rows.join('\n') + '\n');
console.log(seconds.toFixed(4));
