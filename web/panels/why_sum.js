// The sum that makes a ray's light, written as one adds on paper: a column for each colour.

import { codesOf, storesPlainly } from '../picture/srgb.js';
import { degrees, factorsOf, glossAngle, sumOf } from '../picture/explained.js';
import { languageNow, t } from '../words/words.js';
import { element } from './element.js';
import { termWords } from './why_words.js';

/** A colour's swatch. */
export function swatch(color, transfer, name = 'swatch') {
  const backgroundColor = `rgb(${codesOf(color, transfer).join(' ')})`;
  return element('span', { class: name, style: { backgroundColor }, 'aria-hidden': 'true' });
}

/** A number with `digits` decimals. */
export function decimals(number, digits = 4) {
  const fixed = { minimumFractionDigits: digits, maximumFractionDigits: digits };
  return number.toLocaleString(languageNow(), fixed);
}

/**
 * The table of a step's node, of a shadow ray's lamp alone; `stepOf(node)` gives the step of a ray
 * that was made, `go(step)` shows it.
 */
export function sumTable({ kind, node, term: lamp }, { transfer, stepOf, go }) {
  const digits = Math.max(...node.color) >= 100 ? 1 : 4;
  const all = rounded(sumOf(node), digits);
  const own = lamp ? all.filter(({ term }) => term.light && term.light === lamp.light) : all;
  const shown = own.filter((row) => row.shown);
  const paint = { node, transfer, digits, stepOf, go };
  return [
    element('table', { class: 'sum' },
      element('caption', {}, t(lamp ? 'why.sumLamp' : 'why.sum')),
      element('thead', {}, element('tr', {}, element('td'),
        ...['red', 'green', 'blue'].map((name) => element('th', { scope: 'col' }, t(`why.${name}`))))),
      ...shown.map((row, i) => termRows(row, paint, !lamp && i > 0)),
      lamp ? null : element('tfoot', {}, ...wholeRows(kind, paint))),
    lamp ? null : zeroWords(own, node),
    element('p', { class: 'note' }, [
      kind === 'primary' && storesPlainly(transfer) && t('why.storedNote', { curve: t(`why.curve_${transfer}`) }),
      t('why.rounding', { digits })].filter(Boolean).join(' ')),
  ];
}

// Each row adds what its rounded sum has more than the one before: so the columns add up.
function rounded(rows, digits) {
  const round = (value) => Math.round(value * 10 ** digits) / 10 ** digits;
  return rows.map((row, i) => ({ ...row,
    sum: row.sum.map(round),
    adds: row.sum.map((value, c) => round(value) - (i > 0 ? round(rows[i - 1].sum[c]) : 0)) }));
}

function termRows({ term, adds, sum }, { node, transfer, digits, stepOf, go }, running) {
  const step = term.node && stepOf(term.node);
  const link = step && element('button', { type: 'button', onclick: () => go(step) },
    t('why.toRay', { number: step.index + 1 }));
  const cells = (color) => numberCells(color, digits);
  return element('tbody', {},
    element('tr', {}, element('th', { colspan: 4, scope: 'rowgroup' },
      element('span', { class: 'term' },
        swatch(adds, transfer), element('strong', {}, termWords(term, node)), link),
      ...formula(term, node).map((words) => element('span', { class: 'formula' }, words)))),
    row(t(`why.value_${term.name}`), cells(term.value)),
    row(t('why.times', { weight: decimals(term.weight) }), cells(adds), 'adds'),
    running && row(t('why.soFar'), cells(sum), 'running'));
}

const numberCells = (color, digits) => color.map((value) => element('td', {}, decimals(value, digits)));

function row(name, cells, kind) {
  return element('tr', { class: kind }, element('th', { scope: 'row' }, name), ...cells);
}

// How a weight comes about, in words and with the numbers put in.
function formula(term, node) {
  const factors = factorsOf(term, node);
  const weight = decimals(term.weight);
  const lines = lampLines(term, node, weight);
  if (factors?.length > 0 && !(term.n_dot_l <= 0)) {
    lines.push(factors.map(({ name }) => t(`why.${name}`)).join(' \u00d7 '));
    const numbers = factors.map(({ value }) => decimals(value)).join(' \u00d7 ');
    if (factors.length > 1) lines.push(`${numbers} = ${weight}`);
  } else if (term.name === 'reflection') {
    lines.push(t('why.mirrors', { weight }));
  } else if (!factors && term.name === 'diffuse') {
    lines.push(t('why.unfactored', { weight }));
  }
  return lines;
}

function lampLines(term, node, weight) {
  if (term.name === 'specular')
    return [t('why.gloss', { angle: decimals(glossAngle(term, node), 1), weight })];
  if (term.name !== 'diffuse') return [];
  const cosine = decimals(term.n_dot_l);
  if (!(term.n_dot_l > 0)) return [t('why.behind', { cosine })];
  return [t('why.angle', { angle: decimals(degrees(term.n_dot_l), 1), cosine })];
}

function wholeRows(kind, { node, transfer, digits }) {
  const { color, transmittance } = node;
  const rows = [row(t('why.whole'), numberCells(color, digits), 'whole')];
  if (transmittance) {
    rows.push(row(`\u00d7 ${t('why.onTheWay')}`, numberCells(transmittance, digits)),
      row(t('why.arrives'), numberCells(color.map((value, c) => value * transmittance[c]), digits), 'whole'));
  }
  if (kind !== 'primary' || !storesPlainly(transfer)) return rows;
  const codes = codesOf(color, transfer).map((code) => element('td', {}, String(code)));
  return [...rows, row(t('why.stored'), codes, 'stored')];
}

function zeroWords(rows, node) {
  const names = rows.filter((each) => !each.shown).map(({ term }) => termWords(term, node));
  return names.length > 0 && element('p', { class: 'note' }, t('why.zero', { names: names.join(', ') }));
}
