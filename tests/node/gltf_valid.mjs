// SPDX-License-Identifier: GPL-3.0-or-later
// Every .glb file of a folder is valid for the Khronos validator, without errors or warnings,
// and there are as many as said:  node gltf_valid.mjs FOLDER COUNT
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import validator from 'gltf-validator';

const [folder, count] = process.argv.slice(2);
const files = readdirSync(folder).filter((name) => name.endsWith('.glb'));
let failed = files.length !== Number(count);
if (failed) console.error(`${folder}: ${files.length} .glb files, expected ${count}`);
for (const name of files) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(join(folder, name))));
  const { numErrors, numWarnings, messages } = report.issues;
  if (numErrors + numWarnings > 0) failed = true;
  for (const { severity, code, message, pointer } of messages)
    if (severity < 2) console.error(`${name}: ${code} at ${pointer}: ${message}`);
  const { totalTriangleCount = 0, totalVertexCount = 0 } = report.info;
  console.log(`${name}: ${totalTriangleCount} triangles, ${totalVertexCount} vertices`);
}
process.exit(failed ? 1 : 0);
