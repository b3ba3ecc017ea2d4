// What the page of documentation tells, in order.

import { code, fields, paragraph, section } from './parts.js';
import { headerLinks, problemLinks, routeSection, titleOf } from './routes.js';
import { anchorOf, schemaParts } from './schema.js';

/** The sections as { id, title, inside, entries }; `entries` are what the contents list of them. */
export function sectionsOf(openapi) {
  const { headers, responses, schemas } = openapi.components;
  const routes = routesOf(openapi);
  // What a problem and an answer to OPTIONS both may carry, any answer may.
  const common = Object.keys(responses.options.headers).filter((name) => name in responses.default.headers);
  return [{
    id: 'requests', title: 'Requests',
    inside: routes.map((route) => routeSection(route, responses, common)),
    entries: routes.map((route) => [route.operationId, titleOf(route)]),
  }, {
    id: 'problems', title: 'Problems',
    inside: [paragraph(['Any request may meet ', ...problemLinks(responses.default), '.']),
      fields(openapi['x-problems'].map(problemRow))],
  }, {
    id: 'headers', title: 'Headers of answers',
    inside: [paragraph(['Any answer may carry ', ...headerLinks(common), '.']),
      fields(Object.entries(headers).map(headerRow))],
  }, {
    id: 'options', title: 'Options of the server',
    inside: [paragraph('Each is a flag of tia serve and an environment variable; the flag wins.'),
      fields(openapi['x-options'].map(optionRow))],
  }, {
    id: 'json', title: 'JSON',
    inside: [paragraph('The shapes of the JSON that requests bring and answers hold, by name.'),
      ...Object.entries(schemas).map(([name, schema]) => section(anchorOf(name), 'h3', code(name), schemaParts(name, schema)))],
    entries: Object.keys(schemas).map((name) => [anchorOf(name), code(name)]),
  }];
}

const routesOf = ({ paths }) => Object.entries(paths).flatMap(([path, operations]) =>
  Object.entries(operations).map(([method, operation]) => ({ ...operation, path, method: method.toUpperCase() })));

const problemRow = ({ type, title, status, description, header }) => ({
  name: type,
  about: `${title}. ${description}`,
  allowed: [`status ${status}`, ...(header ? [', with ', ...headerLinks([header])] : [])],
  id: `problem-${type.split('/').at(-1)}`,
});

const headerRow = ([name, { description: about, schema }]) =>
  ({ name, about, allowed: [code(schema.pattern)], id: `header-${name}` });

const optionRow = ({ name, flag, variable, description: about, allowed, default: standard }) =>
  ({ name: `${flag} ${variable}`, about, allowed: [allowed], standard, id: `option-${name}` });
