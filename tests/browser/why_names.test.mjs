// What sentences call the objects of an explanation: by name, and by place where that is not enough.
// Runs in Node alone.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { calledApart } from '../../web/picture/called.js';
import { lampWords, thingWords } from '../../web/panels/why_words.js';

const objects = [
  { id: 1, name: 'twin', pointer: '/objects/0', type: 'sphere' },
  { id: 2, name: 'floor', pointer: '/objects/1', type: 'plane' },
  { id: 3, name: 'twin', pointer: '/objects/2/children/0', type: 'disc' },
  { id: 4, name: '/objects/3', pointer: '/objects/3', type: 'box' },
  { id: 5, name: 'brick', pointer: '/objects/4/children/0', type: 'box' },
  { id: 6, name: '/lights/0', pointer: '/lights/0', type: 'sphere' },
];
const hit = (id, copy) => ({ t: id, object: objects[id - 1].name, id, ...(copy && { copy }) });

test('a name that others have, or none, or a copy, is told with its place; another alone', () => {
  const hits = [hit(1), hit(2), hit(3), hit(4), hit(5), hit(5, [[1, 0, 2]]), hit(5, [[0, 1, 0], [4, 0, 0]])];
  const told = calledApart({ tree: { winner: null, terms: [] }, hits, objects }).hits;
  assert.deepEqual(told.map(({ object }) => thingWords(object)), [
    'the twin (/objects/0)', 'the floor', 'the twin (/objects/2/children/0)', 'object 4 (/objects/3)', 'the brick',
    'the brick (/objects/4/children/0, copy 1, 0, 2)',
    'the brick (/objects/4/children/0, copy 0, 1, 0; 4, 0, 0)',
  ]);
});

test('winners, blockers and lights are told apart likewise, all down the tree, one object as one value', () => {
  const copy = [[1, 0, 0]];
  const tree = {
    winner: 'twin', winner_id: 1,
    terms: [
      { name: 'diffuse', light: '/lights/0', light_id: 6, blocker: 'twin', blocker_id: 1 },
      { name: 'diffuse', light: '/lights/1', blocker: 'brick', blocker_id: 5, blocker_copy: copy },
      { name: 'reflection', node: { winner: 'brick', winner_id: 5, winner_copy: copy, terms: [] } },
    ],
  };
  const told = calledApart({ tree, hits: [], objects }).tree;
  assert.equal(thingWords(told.winner), 'the twin (/objects/0)');
  assert.equal(told.terms[0].blocker, told.winner);
  assert.equal(lampWords(told.terms[0].light), 'lamp 1');
  assert.equal(lampWords(told.terms[1].light), 'lamp 2');
  assert.equal(told.terms[2].node.winner, told.terms[1].blocker);
  assert.equal(thingWords(told.terms[1].blocker), 'the brick (/objects/4/children/0, copy 1, 0, 0)');
  assert.equal(tree.winner, 'twin', 'the answer itself stays as it is');
});
