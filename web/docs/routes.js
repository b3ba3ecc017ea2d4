// A request and its answers: an operation of the OpenAPI document.

import { element } from '../panels/element.js';
import { code, fields, joined, link, NOTE, paragraph, section } from './parts.js';
import { fieldRow, schemaWords } from './schema.js';

const PROBLEM = 'application/problem+json';

/** Links to the problems that an answer of the document may tell. */
export const problemLinks = ({ content = {} }) =>
  joined((content[PROBLEM]?.schema.properties.type.enum ?? []).map((uri) => {
    const type = uri.split('/').at(-1);
    return [link(`problem-${type}`, code(type))];
  }), ', ');

/** Links to headers by their names. */
export const headerLinks = (names) =>
  joined(names.map((name) => [link(`header-${name}`, code(name))]), ', ');

/** "GET /render". */
export const titleOf = ({ method, path }) => [element('span', { class: 'method' }, method), ' ', code(path)];

/** All about a route; `common`: the headers that any answer may carry. */
export const routeSection = (route, answers, common) =>
  section(route.operationId, 'h3', titleOf(route), [
    paragraph(route.summary),
    ...examples(route),
    ...parameters(route),
    ...body(route),
    element('h4', {}, 'Answers'),
    element('dl', { class: 'fields answers' }, Object.entries(route.responses)
      .filter(([status]) => status !== 'default')
      .map(([status, answer]) => element('div', {}, element('dt', {}, code(status)),
        element('dd', {}, answer.$ref ? paragraph(problemLinks(answers[status])) : answerParts(answer, common))))),
  ]);

const examples = ({ 'x-examples': targets }) => targets ? [
  element('ul', { class: 'examples' }, targets.map((target) =>
    element('li', {}, element('a', { href: target.slice(1) }, code(target)))))] : [];

const parameters = ({ parameters: all }) => all ? [
  element('h4', {}, 'Parameters'),
  fields(all.map(({ name, description: about, required, schema, content }) => {
    if (schema) return { ...fieldRow(name, schema, required), about };
    const row = fieldRow(name, content['application/json'].schema, required);
    return { ...row, about, allowed: ['as JSON ', ...row.allowed] };
  }))] : [];

const body = ({ path, requestBody }) => requestBody ? [
  element('h4', {}, 'Body'),
  ...Object.entries(requestBody.content).flatMap(([type, media]) => [
    paragraph(contentWords(type, media)),
    ...Object.values(media.examples ?? {}).map(({ summary, value }) =>
      element('pre', {}, code(`# ${summary}\ncurl localhost:8080${path} -d '${lineOf(value)}'`))),
  ])] : [];

// JSON in one line that has spaces to break at.
const lineOf = (value) => JSON.stringify(value, null, 1).replace(/(?<=[[{])\n *|\n *(?=[\]}])/g, '').replace(/\n */g, ' ');

const contentWords = (type, { schema }) => (schema ? [code(type), ': ', ...schemaWords(schema)] : [code(type)]);

function answerParts(answer, common) {
  const contents = Object.entries(answer.content ?? {}).filter(([type]) => type !== PROBLEM);
  const problems = problemLinks(answer);
  const headers = headerLinks(Object.keys(answer.headers).filter((name) => !common.includes(name)));
  return [
    paragraph(answer.description),
    paragraph(joined(contents.map(([type, media]) => contentWords(type, media)), ', or '), NOTE),
    headers.length > 0 && paragraph(['with ', ...headers], NOTE),
    problems.length > 0 && paragraph(['or ', ...problems]),
  ];
}
