// What is in a model, in words.

import { countWords, numberWords, t } from '../words/words.js';
import { element } from './element.js';

/** The nodes that tell a description of /models. */
export function aboutModel(description) {
  return [element('dl', { class: 'facts' }, factsOf(description).map(([name, value]) =>
    element('div', {}, element('dt', {}, t(`model.${name}`)), element('dd', {}, value)))),
  ...warningsOf(description.warnings)];
}

function factsOf(description) {
  const { format, bytes, files, generator, copyright, bounds, up } = description;
  const count = (name) => [name, countWords(Array.isArray(description[name]) ? description[name].length : description[name])];
  const counts = ['triangles', 'points', 'vertices', 'nodes', 'materials', 'textures', 'cameras', 'lights', 'animations', 'variants'];
  const size = bounds && [0, 1, 2].map((i) => numberWords(bounds.max[i] - bounds.min[i])).join(' \u00d7 ');
  return [
    ['format', format.toUpperCase()],
    ['bytes', files.length > 1 ? t('model.inFiles', { bytes: countWords(bytes), files: countWords(files.length) }) : countWords(bytes)],
    ...counts.map(count).filter(([, words]) => words !== '0'),
    size && ['size', `${size} (${t('model.up', { up })})`],
    generator && ['generator', generator],
    copyright && ['copyright', copyright],
  ].filter(Boolean);
}

function warningsOf(warnings) {
  if (!warnings.length) return [];
  return [element('details', { class: 'warnings' },
    element('summary', {}, t('model.warnings', { count: countWords(warnings.length) })),
    element('ul', {}, warnings.map(({ pointer, line, text }) =>
      element('li', {}, pointer ? `${pointer}: ` : line ? `${t('model.line', { line })}: ` : '', element('span', { lang: 'en' }, text)))))];
}
