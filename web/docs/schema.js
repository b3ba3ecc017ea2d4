// A JSON Schema for people: in words, or as lists of fields.

import { element } from '../panels/element.js';
import { code, fields, joined, link, paragraph, plain } from './parts.js';

const NAMED = '#/components/schemas/';

/** Where the page tells of the schema called `name`. */
export const anchorOf = (name) => `json-${name}`;

/** What obeys a schema, as texts and elements: "a number from 0 to 1", with links to named schemas. */
export function schemaWords(schema) {
  if (schema.$ref) {
    const name = schema.$ref.slice(NAMED.length);
    return [link(anchorOf(name), name)];
  }
  if ('const' in schema) return [code(plain(schema.const))];
  if (schema.enum) {
    const about = new Map(schema.oneOf?.map((word) => [word.const, ` (${word.description})`]));
    return ['one of ', ...joined(schema.enum.map((value) => [code(plain(value)), about.get(value) ?? '']), ', ')];
  }
  const either = schema.oneOf ?? schema.anyOf;
  if (either) return joined(either.map(schemaWords), ' or ');
  if (schema.contentSchema) return ['as JSON ', ...schemaWords(schema.contentSchema)];
  return TYPES[schema.type]?.(schema) ?? ['any value'];
}

const TYPES = {
  number: (schema) => [`a number${range(schema)}`],
  integer: (schema) => [`an integer${range(schema)}`],
  string: ({ maxLength }) => [maxLength ? `text of at most ${maxLength} characters` : 'text'],
  boolean: () => [code('true'), ' or ', code('false')],
  null: () => [code('null')],
  array: arrayWords,
  object: objectWords,
};

// 1000000000 as 1e9.
const short = (number) => String(number).replace(/(?<=[1-9])0{6,}$/, (zeros) => `e${zeros.length}`);

function range({ minimum, maximum, exclusiveMinimum: above, not }) {
  const [from, to] = [minimum, maximum].map((end) => end !== undefined);
  const start = from ? (to ? ` from ${short(minimum)}` : `, at least ${short(minimum)}`)
    : above !== undefined ? ` above ${short(above)}` : '';
  const end = !to ? '' : start ? ` to ${short(maximum)}` : `, at most ${short(maximum)}`;
  return start + end + (not ? ', not 0' : '');
}

function arrayWords({ items, minItems: least, maxItems: most }) {
  const numbers = { number: ' numbers', integer: ' integers' }[items?.type];
  const some = least === undefined ? '' : ` at least ${least}`;
  const exact = least !== undefined && least === most;
  if (numbers) {
    const each = range(items).replace(/^,? /, '');
    return [(exact ? least : `a list of${some}`) + numbers + (each && `, each ${each}`)];
  }
  const words = exact ? `${least} values` : `a list${some && ` of${some}`}`;
  return typeof items === 'object' ? [`${words}, each `, ...schemaWords(items)] : [words];
}

function objectWords({ properties = {}, additionalProperties: others }) {
  const members = Object.entries(properties).map(([name, each]) => [code(name), ' (', ...schemaWords(each), ')']);
  if (members.length > 0) return ['an object of ', ...joined(members, ', ')];
  return typeof others === 'object' ? ['an object whose members are each ', ...schemaWords(others)] : ['an object'];
}

/** A row of a list of fields. */
export const fieldRow = (name, schema, required) =>
  ({ name, about: schema.description, allowed: schemaWords(schema), required, standard: schema.default });

const rowsOf = ({ properties = {}, required = [] }) =>
  Object.entries(properties).map(([name, schema]) => fieldRow(name, schema, required.includes(name)));

const kindOf = ({ properties }) => properties?.type?.const;

/** All about a named schema: its fields, or those of each kind where a key `type` tells kinds apart. */
export function schemaParts(name, schema) {
  const kinds = schema.properties ? [] : schema.oneOf ?? [];
  if (kinds.length > 0 && kinds.every(kindOf)) return kindParts(anchorOf(name), kinds);
  return fields(rowsOf(schema)) || paragraph(schemaWords(schema));
}

// What all kinds have alike is told once, before what each has of its own.
function kindParts(anchor, kinds) {
  const all = (field) => new Set(kinds.map(({ properties }) => JSON.stringify(properties[field]))).size === 1;
  const rows = (kind, common) => rowsOf(kind).filter(({ name }) => name !== 'type' && all(name) === common);
  const links = kinds.map((kind) => [link(`${anchor}-${kindOf(kind)}`, code(kindOf(kind)))]);
  const type = { name: 'type', about: 'the kind, with fields of its own', allowed: ['one of ', ...joined(links, ', ')], required: true };
  return [fields([type, ...rows(kinds[0], true)]), ...kinds.flatMap((kind) => [
    element('h4', { id: `${anchor}-${kindOf(kind)}` }, code(kindOf(kind))), fields(rows(kind, false))])];
}
