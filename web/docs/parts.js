// What the page of documentation is put together from.

import { element } from '../panels/element.js';

export const NOTE = { class: 'note' };

export const code = (text) => element('code', {}, text);

/** A link to a place on the page. */
export const link = (id, inside) => element('a', { href: `#${id}` }, inside);

/** A part of the page that the contents list: under a heading of that level, or with one inside. */
export const section = (id, heading, title, inside) =>
  element('section', { id }, element(heading, {}, title), inside);

/** A paragraph of a text or a list of texts and elements; none of nothing. */
export const paragraph = (inside, properties = {}) =>
  inside?.length > 0 && element('p', properties, inside);

/** Lists as one, `between` them. */
export const joined = (lists, between) =>
  lists.flatMap((list, i) => (i > 0 ? [between, ...list] : list));

/** A value as a person writes it: texts as they are, all else as JSON. */
export const plain = (value) => (typeof value === 'string' && value ? value : JSON.stringify(value));

/**
 * A list of fields. A row is { name, about, allowed, required, standard, id }: `allowed` is a list
 * of texts and elements, `standard` the default, `id` a place to link to.
 */
export const fields = (rows) => rows.length > 0 &&
  element('dl', { class: 'fields' }, rows.map(({ name, about, allowed, required, standard, id }) =>
    element('div', { id },
      element('dt', {}, code(name)),
      element('dd', {}, paragraph(about), paragraph([
        ...allowed,
        required && '; required',
        ...(standard === undefined ? [] : ['; default ', code(plain(standard))]),
      ], NOTE)))));
