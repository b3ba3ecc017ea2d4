// A pixel's explanation made ready to be shown: the tree of /explain as rays, one step after the other.

import { add, dot, length, scale, subtract } from '../space/vec.js';

const FAINTEST = 0.002; // of the pixel's light that a ray must be able to bring to be walked through
const MOST = 200; // rays that a person may want to step through
const SAME = 1e-5; // what float arithmetic leaves between a weight and the product of its factors

const KINDS = { reflection: 'mirror', refraction: 'refracted', straight: 'straight' };
const any = (value) => value.some((part) => part > 0);

/**
 * The rays as steps, each before those that it makes: { kind: 'primary' | 'shadow' | 'mirror' |
 * 'refracted' | 'straight', from, to, node, term, parent, weight, index, blocked }. A shadow ray has its lamp's
 * `term` and the node that it lights; `parent` is the step that made a ray, `weight` how much of it
 * counts there. Rays without an end are `reach` long. `left`: the rays that are too faint to list.
 */
export function stepsOf(tree, reach) {
  const steps = [];
  let left = 0;
  const put = (step) => steps[steps.push({ ...step, index: steps.length }) - 1];

  function walk(node, kind, parent, weight, share) {
    const { origin, direction } = node.ray;
    const to = node.point ?? along(origin, direction, reach);
    const step = put({ kind, from: origin, to, node, term: null, parent, weight, blocked: false });
    for (const term of node.terms.filter((it) => castsShadowRay(it, node))) {
      const lamp = along(node.point, term.direction, term.distance ?? reach);
      put({ kind: 'shadow', from: node.point, to: lamp, node, term, parent: step, weight: term.weight,
        blocked: Boolean(term.blocker) });
    }
    for (const term of node.terms.filter((it) => it.node)) {
      const part = share * term.weight;
      if (part < FAINTEST || steps.length >= MOST) left += countRays(term.node);
      else walk(term.node, KINDS[term.name], step, term.weight, part);
    }
  }

  walk(tree, 'primary', null, 1, 1);
  return { steps, left };
}

export const along = (from, direction, by) => add(from, scale(direction, by));

// The server asks for a lamp behind the horizon without a ray, and for one whose light the surface
// swallows with a ray that tells a person nothing.
function castsShadowRay(term, { terms }) {
  if (term.name !== 'diffuse' || !(term.n_dot_l > 0)) return false;
  return any(term.value) || terms.some(({ name, light }) => name === 'specular' && light === term.light);
}

function countRays({ terms }) {
  return terms.reduce((sum, { node }) => sum + (node ? countRays(node) : 0), 1);
}

/** How long a ray without an end is drawn: beyond all that the tree's rays have met. */
export function reachOf(tree, least) {
  const far = (node) => Math.max(
    node.point ? length(subtract(node.point, tree.ray.origin)) : 0,
    ...node.terms.map(({ node: child }) => (child ? far(child) : 0)));
  return Math.max(least, 1.25 * far(tree));
}

/** What its surface keeps of a node's own light: what it does not let through. */
export const keptBy = ({ terms }) => (terms[0].name === 'emission' ? terms[0].weight : 1);

/**
 * The factors whose product is a term's weight, as [{ name, value }]; null where a weight has none
 * that the answer tells, such as a gloss, a brilliance or a mean over a large lamp's places.
 */
export function factorsOf(term, node) {
  const factors = claimed(term, node);
  const product = factors?.reduce((all, { value }) => all * value, 1);
  return factors && Math.abs(product - term.weight) <= SAME * Math.max(1, term.weight) ? factors : null;
}

// The formulas of core/integrators: whitted.h's shade, direct.h's lights, finishes.h's split.
function claimed(term, node) {
  const keep = keptBy(node);
  const kept = keep < 1 ? [{ name: 'keep', value: keep }] : [];
  if (term.name === 'emission' || term.name === 'ambient') return kept;
  if (term.name === 'diffuse') {
    const faded = term.fade === 1 ? [] : [{ name: 'fade', value: term.fade }];
    const straight = { name: 'nDotL', value: Math.max(0, term.n_dot_l) };
    return [straight, { name: 'visible', value: term.visible }, ...faded, ...kept];
  }
  if (keep === 1 || !KINDS[term.name]) return null;
  const through = 1 - keep;
  const passing = (node.terms.find(({ name }) => name === 'refraction')?.weight ?? 0) / through;
  const share = term.name === 'refraction' ? { name: 'passing', value: passing }
    : { name: 'mirrored', value: 1 - passing };
  return [{ name: 'through', value: through }, share];
}

/** The angle in degrees between the mirrored ray and the way to a lamp: what a gloss goes by. */
export function glossAngle({ direction }, { ray, normal }) {
  const mirrored = subtract(ray.direction, scale(normal, 2 * dot(ray.direction, normal)));
  return degrees(dot(mirrored, direction));
}

export const degrees = (cosine) => (Math.acos(Math.min(1, Math.max(-1, cosine))) * 180) / Math.PI;

/**
 * The sum that makes a node's colour, as it stands in the answer: [{ term, adds, sum }] with each
 * term's weight * value and what there is with it. `shown` tells which have something to tell.
 */
export function sumOf({ terms, color }) {
  let sum = [0, 0, 0];
  return terms.map((term, i) => {
    const adds = scale(term.value, term.weight);
    // The server adds in float: its own sum is the last word, and no part may go beyond it.
    sum = i === terms.length - 1 ? color : add(sum, adds).map((value, c) => Math.min(value, color[c]));
    const tells = any(adds) || Boolean(term.node) || (term.name === 'diffuse' && any(term.value));
    return { term, adds, sum, shown: tells };
  });
}
