// SPDX-FileCopyrightText: 2026 The echoarc authors
// SPDX-License-Identifier: Apache-2.0

/** Makes src/protocol/messages.ts from the schema of the messages; with --check it only compares, for continuous integration. */
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { compile } from 'json-schema-to-typescript';

const web = dirname(dirname(fileURLToPath(import.meta.url)));
const target = join(web, 'src', 'protocol', 'messages.ts');
const schema = JSON.parse(readFileSync(join(web, '..', 'schema', 'messages.schema.json'), 'utf8'));

// Every definition is wanted under its own name, also those that nothing refers to; titles would rename them.
delete schema.title;
delete schema.$id;
const text = await compile(schema, 'AnyMessage', {
  bannerComment: [
    '// SPDX-FileCopyrightText: 2026 The echoarc authors',
    '// SPDX-License-Identifier: Apache-2.0',
    '',
    '// Made from schema/messages.schema.json by `npm run types`; edits are lost.',
  ].join('\n'),
  additionalProperties: false,
  format: false,
  maxItems: 4, // longer lists are arrays, not unions of tuples
  unreachableDefinitions: true,
});

if (!process.argv.includes('--check')) {
  writeFileSync(target, text);
} else if (readFileSync(target, 'utf8') !== text) {
  console.error('src/protocol/messages.ts is not what the schema says: run `npm run types` and commit it.');
  process.exit(1);
}
