// One word for what is recorded, throughout a page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { capitalised, counted, nounOf, nounOfAll, oneOf } from '../../src/text/noun';

const kAnimals = { one: 'animal', several: 'animals' };
const kAircraft = { one: 'aircraft', several: 'aircraft' };
const shown = (noun?: { one: string; several: string }): { swarm: { head: { noun?: { one: string; several: string } } } } => ({ swarm: { head: noun ? { noun } : {} } });

test('what is recorded is counted by its name, or as bees', () => {
  assert.deepEqual([counted(1, kAnimals), counted(1234, kAircraft), counted(2, nounOf({}))], ['1 animal', '1,234 aircraft', '2 bees']);
  assert.deepEqual([oneOf(kAnimals), oneOf(nounOf({})), capitalised('bees')], ['an animal', 'a bee', 'Bees']);
});

test('two that are compared have one word, which both have', () => {
  assert.equal(nounOfAll([shown(kAnimals), shown(kAnimals)]).one, 'animal');
  assert.equal(nounOfAll([shown(kAnimals), shown()]).one, 'bee');
});
