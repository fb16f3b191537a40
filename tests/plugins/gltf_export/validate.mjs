// SPDX-License-Identifier: MIT
// Prints what Khronos' validator finds in glTF files: node validate.mjs MODULE_FOLDER FILE...
// One line "ERROR code pointer message" or "FILE: n errors, m warnings"; exit status 1 when there is an error.
import { createRequire } from 'node:module';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

const [folder, ...files] = process.argv.slice(2);
const validator = createRequire(join(folder, 'anchor.js'))('gltf-validator');
let errors = 0;
for (const file of files) {
  const report = await validator.validateBytes(new Uint8Array(readFileSync(file)), {
    uri: file,
    externalResourceFunction: async (uri) => new Uint8Array(readFileSync(join(dirname(file), decodeURIComponent(uri)))),
  });
  for (const message of report.issues.messages.filter((m) => m.severity === 0))
    console.log(`ERROR ${message.code} ${message.pointer ?? message.offset} ${message.message}`);
  console.log(`${file}: ${report.issues.numErrors} errors, ${report.issues.numWarnings} warnings`);
  errors += report.issues.numErrors;
}
process.exit(errors ? 1 : 0);
