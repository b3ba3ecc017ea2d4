// What a form can show of a scene: its parts, and each part's fields as the server's schema
// describes them.

import { token, valueAt } from './scene_text.js';

const ORDER = ['name', 'title', 'description', 'background', 'location', 'look_at', 'direction',
  'position', 'center', 'min', 'max', 'base', 'cap', 'radius', 'color', 'intensity', 'ambient',
  'diffuse', 'specular', 'roughness', 'reflection', 'transmission', 'ior'];
const MOST_PARTS = 400; // a longer list helps nobody

/** The parts of a scene as [{ group, pointer, name, type, depth }], in the scene's order. */
export function partsOf(scene) {
  const lights = listOf(scene.lights).map((light, i) => part('lights', `/lights/${i}`, light));
  return [
    ...objectsBelow(scene.objects, '/objects', 0),
    ...Object.keys(objectOf(scene.materials)).map((name) =>
      ({ group: 'materials', pointer: `/materials/${token(name)}`, name })),
    ...lights,
    ...(scene.key_light ? [part('lights', '/key_light', scene.key_light)] : []),
    { group: 'picture', pointer: '/camera' },
    { group: 'picture', pointer: '' },
    { group: 'picture', pointer: '/options' },
  ].slice(0, MOST_PARTS);
}

const objectOf = (value) =>
  (value !== null && typeof value === 'object' && !Array.isArray(value) ? value : {});
const listOf = (value) => (Array.isArray(value) ? value : []);

function part(group, pointer, value, depth = 0) {
  const { name, type } = objectOf(value);
  return { group, pointer, name, type, depth };
}

function objectsBelow(objects, pointer, depth) {
  return listOf(objects).flatMap((object, i) => [
    part('objects', `${pointer}/${i}`, object, depth),
    ...objectsBelow(objectOf(object).children, `${pointer}/${i}/children`, depth + 1),
  ]);
}

/** Where the material of a part stands, or null: in the object, or by its name in the scene. */
export function materialOf(scene, { group, pointer, depth }) {
  if (group !== 'objects') return null;
  const material = valueAt(scene, `${pointer}/material`);
  if (typeof material === 'string') {
    const named = `/materials/${token(material)}`;
    return valueAt(scene, named) === undefined ? null : { pointer: named, name: material };
  }
  return material === undefined && depth > 0 ? null : { pointer: `${pointer}/material` };
}

/** What the schema says of the thing at `pointer`. */
export function schemaOf(schema, scene, pointer) {
  const type = valueAt(scene, pointer)?.type;
  const kind = (name) => schema.$defs[name];
  const one = (name) => (kind(name).oneOf ?? [kind(name)]).find(({ properties, required }) =>
    (type ? properties.type?.const === type : !required?.includes('type')));
  if (pointer === '') return schema;
  if (pointer === '/camera' || pointer === '/options') return kind(pointer.slice(1));
  if (/^\/materials\/[^/]*$|\/material$/.test(pointer)) return one('material');
  return one(/^\/lights\/|^\/key_light/.test(pointer) ? 'light' : 'object');
}

/**
 * The fields of the thing at `pointer` as [{ name, pointer, kind, value, schema, range }], `kind`
 * `number`, `numbers`, `color`, `choice`, `truth` or `text`; those that are neither there nor have
 * a default are left out, as are lists and objects.
 */
export function fieldsOf(schema, scene, pointer) {
  const thing = objectOf(valueAt(scene, pointer));
  const own = schemaOf(schema, scene, pointer);
  const rank = ([name]) => (ORDER.includes(name) ? ORDER.indexOf(name) : ORDER.length);
  return Object.entries(own?.properties ?? {}).sort((a, b) => rank(a) - rank(b)).flatMap(([name, whole]) => {
    const field = { ...whole, ...whole.anyOf?.[0] };
    const given = Object.hasOwn(thing, name);
    const value = given ? thing[name] : field.default;
    const kind = kindOf(field);
    if (!kind || value === undefined || !suits(kind, value)) return [];
    const place = `${pointer}/${token(name)}`;
    return [{ name, pointer: place, kind, value, schema: field, range: rangeOf(kind, field, value) }];
  });
}

function kindOf({ type, items, maxItems, oneOf, enum: choices }) {
  if (choices) return 'choice';
  if (type === 'number' || type === 'integer') return 'number';
  if (type === 'boolean') return 'truth';
  if (type === 'string') return 'text';
  if (type === 'array' && maxItems <= 4 && ['number', 'integer'].includes(items?.type)) return 'numbers';
  return oneOf?.length === 2 && oneOf[0].items?.minimum === 0 && oneOf[1].minimum === 0 ? 'color' : null;
}

const isNumbers = (value) => Array.isArray(value) && value.every((one) => typeof one === 'number');

function suits(kind, value) {
  if (kind === 'number') return typeof value === 'number';
  if (kind === 'numbers') return isNumbers(value) && value.length > 0;
  if (kind === 'color') return typeof value === 'number' || (isNumbers(value) && value.length === 3);
  if (kind === 'truth') return typeof value === 'boolean';
  return typeof value === 'string';
}

/** A slider's { min, max, step }: the schema's own range where a hand can use it, else around `value`. */
export function rangeOf(kind, { type, minimum, exclusiveMinimum, maximum }, value) {
  if (kind !== 'number') return null;
  const least = minimum ?? exclusiveMinimum ?? -Infinity;
  const wide = !(maximum - least <= 200);
  const max = wide ? Math.min(maximum ?? Infinity, roundUp(2 * Math.abs(value) || 1)) : maximum;
  const low = wide && least < 0 ? -max : least;
  const step = type === 'integer' ? 1 : 10 ** Math.floor(Math.log10((max - low) / 100));
  const first = Math.ceil(low / step - 1e-9) * step; // the steps count from here: round ones
  return { min: Number((first === exclusiveMinimum ? step : first).toPrecision(9)), max, step };
}

function roundUp(value) {
  const ten = 10 ** Math.floor(Math.log10(value));
  return ten * [1, 2, 5, 10].find((times) => times * ten >= value * 0.999999);
}
