// What an explanation calls its objects, made ready for sentences: where a name does not tell which
// object is meant, its place in the scene goes with it.

const MENTIONS = ['winner', 'blocker', 'light'];

/**
 * The { tree, hits, over, samples } of an explanation, each object named by its name where that is enough; else,
 * where there is none, where others have the same, and of copies, by { name, pointer, copy }: `copy`
 * is 'x, y, z' of each repeated group, or ''. One object is one value all over.
 */
export function calledApart({ tree = {}, hits, objects, over = [], samples = [] }) {
  const entries = new Map(objects.map((entry) => [entry.id, entry]));
  const bearers = new Map();
  for (const { name } of objects) bearers.set(name, (bearers.get(name) ?? 0) + 1);
  const known = new Map();

  function called(name, id, places = []) {
    const copy = places.map((place) => place.join(', ')).join('; ');
    const entry = entries.get(id);
    const isLamp = !entry?.pointer.startsWith('/objects/');
    if (isLamp || (!copy && name !== entry.pointer && bearers.get(name) === 1)) return name;
    const key = `${id} ${copy}`;
    if (!known.has(key)) known.set(key, { name, pointer: entry.pointer, copy });
    return known.get(key);
  }
  function inside(told) {
    const own = { ...told };
    for (const mention of MENTIONS)
      if (told[mention]) own[mention] = called(told[mention], told[`${mention}_id`], told[`${mention}_copy`]);
    if (told.terms) own.terms = told.terms.map(inside);
    if (told.node) own.node = inside(told.node);
    return own;
  }
  const thing = (one) => (one.object === undefined ? one : { ...one, object: called(one.object, one.id, one.copy) });
  const vertex = (one) => ({ ...thing(one), lights: one.lights.map(inside) });
  return {
    tree: inside(tree),
    hits: hits.map(thing),
    over: over.map((one) => ({ ...thing(one), pointer: entries.get(one.id)?.pointer })),
    samples: samples.map((path) => ({ ...path, vertices: path.vertices.map(vertex) })),
  };
}
