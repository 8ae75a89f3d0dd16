// SPDX-License-Identifier: GPL-3.0-or-later
// node grammar.mjs PROJECT LANGUAGE-WORDS VERSION [--accept]
//
// The grammar for editors, read by the engine of VS Code: it knows every word of the language, finds
// nothing wrong in any file that is right, and colours a sample as sample.scopes says.
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';

const [project, languageWords, version, accept] = process.argv.slice(2);
const require = createRequire(join(project, 'tests/node/package.json'));
const oniguruma = require('vscode-oniguruma');
const textmate = require('vscode-textmate');

const extension = join(project, 'src/claims/vscode');
const read = (...path) => readFileSync(join(...path), 'utf8');
const failures = [];
const expect = (holds, message) => holds || failures.push(message);

await oniguruma.loadWASM(readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm')).buffer);
const registry = new textmate.Registry({
  onigLib: Promise.resolve({
    createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
    createOnigString: (text) => new oniguruma.OnigString(text),
  }),
  loadGrammar: async () => JSON.parse(read(extension, 'syntaxes/seam.tmLanguage.json')),
});
const grammar = await registry.loadGrammar('source.seam');

// The tokens of a text, each with its innermost scope but for `.seam`.
function tokens(text) {
  const result = [];
  let state = textmate.INITIAL;
  for (const line of text.split(/\r?\n/)) {
    const tokenized = grammar.tokenizeLine(line, state);
    state = tokenized.ruleStack;
    for (const { startIndex, endIndex, scopes } of tokenized.tokens) {
      const word = line.slice(startIndex, endIndex);
      if (word.trim()) result.push({ word, scope: scopes.at(-1).replace(/\.seam$/, ''), line });
    }
  }
  return result;
}
const scopeOf = (word, text) => tokens(text).find((token) => token.word.trim() === word)?.scope ?? 'nothing';

// Every function, predicate and part of a figure, where it stands.
const kinds = {
  function: { places: (word) => [`    ${word}(x)`, `    1 + ${word}`], scope: /^(support\.function|support\.constant|constant\.language)$/ },
  predicate: { places: (word) => [`    ${word}(x)`, `    not ${word}(x)`], scope: /^support\.function\.predicate$/ },
  part: { places: (word) => [`    S with ${word}`, `    S with x, ${word}`], scope: /^support\.constant$/ },
};
const language = execFileSync(languageWords, { encoding: 'utf8' }).trim().split('\n').map((line) => line.split(' '));
expect(language.length > 50, 'the language has hardly any words');
for (const [kind, word] of language)
  for (const place of kinds[kind].places(word))
    expect(kinds[kind].scope.test(scopeOf(word, place)), `${kind} '${word}' is ${scopeOf(word, place)} in '${place}'`);

// And no other.
const coloured = JSON.parse(read(extension, 'syntaxes/seam.tmLanguage.json')).repository.statement.patterns
  .filter(({ name }) => name?.startsWith('support.'))
  .flatMap(({ match }) => /\(\?:(\w+(?:\|\w+)*)\)/.exec(match)[1].split('|'));
for (const word of coloured)
  expect(language.some(([, known]) => known === word), `the language has no word '${word}'`);

// Every keyword, in one of the places where it may stand.
const keywords = [...read(project, 'src/claims/tokens.h').matchAll(/(?:SEAM_KEYWORD\(\w+, |TAO_PEGTL_STRING\()"(\w+)"/g)].map((found) => found[1]);
expect(keywords.length > 50, 'the grammar has hardly any keywords');
for (const word of keywords) {
  const places = [`${word} `, `${word} "x"`, `${word} 2`, `param n : ${word}`, `param n : ${word} 3`, `param n : function ${word} 2`, `for ${word} x: y`, `    expect ${word}`, `    x ${word} by y`, `    S ${word} net`];
  const scopes = places.map((place) => scopeOf(word, place));
  expect(scopes.some((scope) => /^(keyword|storage|constant)/.test(scope)), `keyword '${word}' is ${[...new Set(scopes)].join(', ')}`);
}

// Files that are right have nothing invalid in them.
const files = ['proofs', 'tests/claims/good'].flatMap((folder) =>
  readdirSync(join(project, folder), { recursive: true }).filter((name) => name.endsWith('.seam')).map((name) => join(folder, name)));
expect(files.length > 50, 'there are hardly any files');
for (const file of files)
  for (const { word, scope, line } of tokens(read(project, file)))
    expect(!scope.startsWith('invalid'), `${file}: '${word}' is ${scope} in: ${line}`);

// A sample, token by token.
const sample = tokens(read(project, 'tests/editor/sample.seam')).map(({ word, scope }) => `${word.trim()}\t${scope}\n`).join('');
const committed = join(project, 'tests/editor/sample.scopes');
if (accept === '--accept') writeFileSync(committed, sample);
expect(sample === read(committed), `the sample is not as in ${committed}; with --accept it is written anew:\n${sample}`);

expect(JSON.parse(read(extension, 'package.json')).version === version, `package.json has not the version ${version}`);

for (const failure of failures.slice(0, 20)) console.error(failure);
process.exitCode = failures.length ? 1 : 0;
