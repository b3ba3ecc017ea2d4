// Sentences about why a pixel has its colour, told from /explain's tree.

import { degrees } from '../picture/explained.js';
import { countWords, t } from '../words/words.js';

const LEAST_PART = 0.05; // of the brightness that is worth a word

const brightness = ([r, g, b]) => r + g + b;
const addsOf = ({ weight, value }) => weight * brightness(value);
/** A share as a number of hundredths. */
export const percent = (share) => countWords(Math.round(share * 100));
const capital = (words) => words.charAt(0).toUpperCase() + words.slice(1);

/** An object as a sentence names it; `label` is its name or calledApart's, null the void. */
export function thingWords(label) {
  if (label === null) return t('why.nothing');
  if (label.pointer) return `${thingWords(label.name)} (${label.pointer}${label.copy && t('why.copy', label)})`;
  const numbers = label.match(/^\/objects\/(.*)$/)?.[1].match(/\d+/g);
  if (numbers) return t('why.object', { number: numbers.map((number) => Number(number) + 1).join('.') });
  return label.startsWith('/') ? lampWords(label) : t('why.the', { name: label });
}

/** A lamp as a sentence names it; the `only` one needs no number. */
export function lampWords(label, only = false) {
  if (label === '/key_light') return t(only ? 'why.lamp' : 'why.handLamp');
  const number = /^\/lights\/(\d+)$/.exec(label)?.[1];
  if (number !== undefined) return only ? t('why.lamp') : t('why.lampNumber', { number: Number(number) + 1 });
  return thingWords(label);
}

/** A lamp of a node's. */
export function lampOf({ light }, { terms }) {
  return lampWords(light, new Set(terms.flatMap((term) => term.light ?? [])).size === 1);
}

/** Why the pixel of this tree has its colour. */
export function whySentence(tree) {
  if (tree.winner === null) return t('why.background');
  const sentences = [mainWords(tree), lampsWords(tree), ...otherLamps(tree), partsWords(tree)];
  return sentences.filter(Boolean).map(capital).join(' ');
}

// The first that fits a light path expression.
const WAYS = [['seen', /^E$/], ['straight', /^[DGV]E$/], ['mirrored', /^[ST]/], ['over', /E$/]];

const LEAST_OVER = 0.01; // of the light that a surface is named for
const MOST_OVER = 3;

/** By which ways the light of a pixel's paths came, and over what; `scene` is its JSON. */
export function waysSentence({ groups, count, over }, scene) {
  const shares = new Map();
  for (const { expression, share } of groups) {
    const [way] = WAYS.find(([, fits]) => fits.test(expression));
    shares.set(way, (shares.get(way) ?? 0) + share);
  }
  const parts = [...shares].sort(([, a], [, b]) => b - a)
    .map(([way, share]) => t(`why.way_${way}`, { share: percent(share) }));
  const paths = countWords(count);
  if (!parts.length) return t('why.noWay', { count: paths });
  const told = over.filter(({ share }) => share >= LEAST_OVER).slice(0, MOST_OVER).map((part, i) =>
    t(i ? 'why.overMore' : 'why.over', { share: percent(part.share), thing: overWords(part, scene) }));
  return [t('why.ways', { count: paths, parts: parts.join(', ') }), told.length && `${told.join(', ')}.`].filter(Boolean).join(' ');
}

/** What light came over, with the name of its material where it has one. */
export function overWords({ object, pointer }, scene) {
  const words = thingWords(object);
  const { material } = pointer?.split('/').slice(1).reduce((at, step) => at?.[step], scene) ?? {};
  return typeof material === 'string' && !words.includes(material) ? `${words} (${material})` : words;
}

/** The stations of a light path expression, from the eye on. */
export function expressionWords({ expression }) {
  const station = (letter) => t(`why.letter_${letter === '*' ? 'more' : letter}`);
  return [...expression].map(station).join(' \u2190 ');
}

function mainWords(tree) {
  const thing = thingWords(tree.winner);
  const main = tree.terms.reduce((most, term) => (addsOf(term) > addsOf(most) ? term : most));
  if (addsOf(main) > 0) {
    if (main.name === 'reflection') return t('why.mirror', { thing, shown: shownBy(main.node) });
    if (main.name === 'refraction') return t('why.glass', { thing, shown: shownBy(main.node) });
    if (main.name === 'emission') return t('why.glows', { thing });
    if (main.name === 'specular') return t('why.highlight', { thing, lamp: lampOf(main, tree) });
  }
  const lamp = mainLamp(tree);
  const cause = lamp ? lampCause(lamp, tree) : t('why.noLamp', { thing });
  const alone = addsOf(main) > 0 && main.name === 'ambient' && !(lamp && addsOf(lamp) > 0);
  return alone ? `${cause} ${t('why.onlyAmbient')}` : cause;
}

// What one sees in a mirror or behind glass: the first thing that does not pass most of it on.
function shownBy(node) {
  const [main] = node.terms.filter((term) => term.node).sort((a, b) => addsOf(b) - addsOf(a));
  const passed = main && addsOf(main) > brightness(node.color) / 2;
  return passed ? shownBy(main.node) : thingWords(node.winner);
}

// The lamp that adds most; where none does, the one that could.
function mainLamp({ terms }) {
  const could = (term) => [addsOf(term), Math.max(0, term.n_dot_l) * brightness(term.value)];
  const stronger = (a, b) => (could(a)[0] - could(b)[0] || could(a)[1] - could(b)[1]) >= 0;
  return lampTerms(terms).reduce((best, term) => (best && stronger(best, term) ? best : term), null);
}

const lampTerms = (terms) => terms.filter(({ name }) => name === 'diffuse');

function lampCause(term, tree) {
  const words = { thing: thingWords(tree.winner), lamp: lampOf(term, tree), share: percent(term.visible) };
  if (term.blocker) words.blocker = thingWords(term.blocker);
  if (brightness(term.value) === 0) return t('why.black', words);
  if (!(term.n_dot_l > 0)) return t('why.away', words);
  if (term.visible === 0 && term.blocker)
    return t(term.blocker === tree.winner ? 'why.ownShadow' : 'why.shadow', words);
  if (term.fade === 0) return t('why.beside', words);
  if (term.visible < 1) return t(term.blocker ? 'why.partly' : 'why.partlySeen', words);
  const angle = countWords(Math.round(degrees(term.n_dot_l)));
  const lit = t('why.lit', { ...words, share: percent(term.n_dot_l), angle });
  return term.fade < 1 ? `${lit} ${t('why.faded', { share: percent(term.fade) })}` : lit;
}

function lampsWords({ terms }) {
  const lamps = lampTerms(terms);
  const lit = lamps.filter((term) => addsOf(term) > 0).length;
  return lit > 0 && lamps.length > 1 ? t('why.lamps', { lit, all: lamps.length }) : '';
}

// Of lamps that are kept away, beside the one that the sentence is about.
function otherLamps(tree) {
  const main = mainLamp(tree);
  const dark = ({ visible, blocker, value }) => visible === 0 && blocker && brightness(value) > 0;
  return lampTerms(tree.terms).filter((term) => term !== main && dark(term)).slice(0, 2)
    .map((term) => t('why.alsoDark', { blocker: thingWords(term.blocker), lamp: lampOf(term, tree) }));
}

function partsWords({ terms, color }) {
  const all = brightness(color);
  const sums = new Map();
  for (const term of terms) sums.set(term.name, (sums.get(term.name) ?? 0) + addsOf(term));
  const parts = [...sums].filter(([, sum]) => sum >= LEAST_PART * all).sort(([, a], [, b]) => b - a);
  if (!(all > 0) || parts.length < 2) return '';
  const told = ([name, sum]) => t('why.part', { name: t(`why.part_${name}`), share: percent(sum / all) });
  return t('why.parts', { parts: parts.map(told).join(', ') });
}

/** What a ray does, in a few words. */
export function stepWords({ kind, node, term, parent }) {
  if (kind !== 'shadow') {
    const from = parent && thingWords(parent.node.winner);
    return capital(t(`why.step_${kind}`, { from, to: thingWords(node.winner) }));
  }
  const { visible, blocker, fade } = term;
  const words = { lamp: lampOf(term, node), share: percent(visible) };
  if (blocker) words.blocker = thingWords(blocker);
  if (visible === 1) return t(fade === 0 ? 'why.step_beside' : 'why.step_shadow', words);
  return t(visible === 0 && blocker ? 'why.step_blocked' : 'why.step_partly', words);
}

const SENT = { specular: 'mirror', transmitted: 'refracted', volume: 'fog' };

/** What a path does on its way to the vertex `at`, in a few words, and the lights that it has there. */
export function vertexWords({ vertices, color }, at) {
  const { object = null, lights } = vertices[at];
  const before = vertices[at - 1];
  const way = before ? SENT[before.event] ?? 'scattered' : 'primary';
  const from = before?.object !== undefined ? thingWords(before.object) : '';
  const lit = lights.filter(({ value }) => brightness(value) > 0).map(({ asked, light, value }) =>
    t(asked ? 'why.path_asked' : 'why.path_met', { share: percent(brightness(value) / brightness(color)),
      lamp: light === '/background' ? thingWords(null) : lampWords(light) }));
  return [t(`why.step_${way}`, { from, to: thingWords(object) }), ...lit].map(capital);
}

/** A term's name. */
export function termWords(term, node) {
  return t(`why.term_${term.name}`, { lamp: term.light && lampOf(term, node) });
}
