// What the numbers of an `object` image mean: things from 1 on, in the order of core/scene/labels,
// where a group's members count and the group does not. Luminous lights follow the objects.

/** Of each number, from 1 on, which of the scene's own objects it belongs to. */
export function ownersOf({ objects = [] } = {}) {
  return objects.flatMap((object, index) => Array(membersOf(object)).fill(index));
}

function membersOf({ type, children = [] }) {
  return type === 'group' ? children.reduce((sum, child) => sum + membersOf(child), 0) : 1;
}

/** Which of the scene's objects a pixel of the image shows; -1 where none. */
export function ownerAt(image, owners, x, y) {
  return owners[image.at(x, y)[0] - 1] ?? -1;
}
