// The server's OpenAPI document before two strangers: the schema that OpenAPI publishes of such
// documents, and ajv, which compiles the document's own schemas and judges real answers by them.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { Validator } from '@seriousme/openapi-schema-validator';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { PARAMETERS } from '../../web/state/request.js';
import { startTia } from './tia.mjs';

let tia, openapi, ajv;
before(async () => {
  tia = await startTia();
  openapi = JSON.parse(await tia.get('/openapi.json'));
  ajv = new Ajv2020({ strict: true, strictTypes: false, strictRequired: false });
  ajv.addKeyword('x-gathers');
  ajv.addKeyword('x-samples');
  ajv.addKeyword('x-max-depth');
  ajv.addKeyword('components'); // all that refers to a schema goes through it
  ajv.addSchema({ $id: 'openapi', components: { schemas: openapi.components.schemas } });
});
after(() => tia?.stop());

const named = (name) => ajv.getSchema(`openapi#/components/schemas/${name}`);

test('is an OpenAPI 3.1 document, by the schema that OpenAPI publishes', async () => {
  const validator = new Validator();
  const { valid, errors } = await validator.validate(structuredClone(openapi));
  assert.ok(valid, JSON.stringify(errors));
  assert.equal(validator.version, '3.1');
});

test('is refused by that schema where anything that it needs is missing', async () => {
  for (const path of ['info.title', 'paths./render.get.responses.200.description', 'openapi',
    'components.headers.ETag.schema']) {
    const broken = structuredClone(openapi);
    const steps = path.split(/\.(?!json)/);
    const last = steps.pop();
    delete steps.reduce((part, step) => part[step], broken)[last];
    const { valid } = await new Validator().validate(broken);
    assert.ok(!valid, path);
  }
});

// What says how a picture's file is made: the page shows PNG alone.
const OF_FILES = ['format', 'aov', 'depth', 'depth_range'];

test('names the parameters that the page knows, and those that are none of a picture’s own', () => {
  const queries = (path) => openapi.paths[path].get.parameters.filter(({ in: place }) => place === 'query')
    .map(({ name }) => name);
  const [render, still] = [queries('/render'), queries('/still')];
  const known = PARAMETERS.filter((name) => render.includes(name) || !still.includes(name)); // but what only stills have
  const unknown = ['acuity', 'acuity.slope', 'acuity.w0_degrees', 'blur_steps', 'frame', 'frame_ms', 'gaze', 'gaze_rays', 'stream', 'threads', 'v'];
  assert.deepEqual(render.toSorted(), [...known, ...OF_FILES, ...unknown].toSorted());
});

test('holds no schema that ajv does not take as JSON Schema 2020-12', () => {
  for (const name of Object.keys(openapi.components.schemas)) assert.ok(named(name), name);
});

test('real answers obey it, and broken ones do not', async () => {
  const answers = {
    '/scenes': 'scene_list',
    '/scenes/whitted': 'scene',
    '/scenes/voxels': 'scene',
    '/version': 'build',
    '/explain?scene=whitted&x=300&y=200': 'explanation',
  };
  for (const [path, name] of Object.entries(answers)) {
    const answer = JSON.parse(await tia.get(path));
    const obeys = named(name);
    assert.ok(obeys(answer), `${path}: ${JSON.stringify(obeys.errors)}`);
    assert.ok(!obeys({ ...answer, unheard_of: 1 }), path);
  }
  const problem = await (await fetch(`${tia.base}/render?width=0`)).json();
  assert.ok(named('problem')(problem));
  assert.ok(!named('problem')({ ...problem, status: 400 }));
});
