// A scene's physics, read and written: which of its objects fall, which stand in the way.

import { add, scale } from '../space/vec.js';

const SOLID = ['sphere', 'plane', 'box', 'triangle', 'mesh', 'cylinder', 'capsule']; // what balls bounce off
const ROUND = ['sphere'];

/** What a body has where nothing is said. */
export const USUAL_BODY = { mass: 1, restitution: 0.8, friction: 0.5, velocity: [0, 0, 0] };

/** How physics calls object `index`: by its name where that means it alone. */
export function calledIn(scene, index) {
  const { name } = scene.objects[index];
  const alone = name && scene.objects.filter((one) => one.name === name).length === 1;
  return alone && !name.startsWith('/') ? name : `/objects/${index}`;
}

/** What each object does: [{ index, name, type, role: 'falls', 'stands' or 'out', body }], body of what falls. */
export function rolesOf(scene) {
  const { bodies = [], fixed = [] } = scene?.physics ?? {};
  return (scene?.objects ?? []).map(({ name, type }, index) => {
    const means = ({ object }) => object === name || object === `/objects/${index}`;
    const body = bodies.find(means);
    const stands = scene.physics ? fixed.some(means) : SOLID.includes(type);
    const role = body ? 'falls' : stands ? 'stands' : 'out';
    return { index, name: name ?? `${type} ${index + 1}`, type, role, body: { ...USUAL_BODY, ...(body && { restitution: 1 }), ...body } };
  });
}

/** The physics of these roles; null where nothing falls. */
export function physicsOf(scene, roles, duration) {
  const falls = roles.filter(({ role }) => role === 'falls');
  if (!falls.length) return null;
  const exact = falls.every(({ type }) => ROUND.includes(type));
  return {
    duration, ...scene.physics, solver: exact ? 'exact' : 'rigid',
    bodies: falls.map(({ index, body }) => ({ ...withMass(body), object: calledIn(scene, index) })),
    fixed: roles.filter(({ role }) => role === 'stands').map(({ index }) =>
      ({ ...standing(scene, index), object: calledIn(scene, index) })),
  };
}

const withMass = ({ mass, density, ...body }) => (density === undefined ? { ...body, mass } : { ...body, density });

const standing = ({ physics }, index) =>
  physics?.fixed?.find(({ object }) => object === `/objects/${index}`) ?? {};

/** Whether any of them turns and rubs. */
export const isRigid = (roles) => roles.some(({ role, type }) => role === 'falls' && !ROUND.includes(type));

/** About where an object is: the middle of its shape, shifted as its transform shifts it. */
export function middleOf({ center, min, max, base, cap, transform = [] }) {
  const between = (a, b) => scale(add(a, b), 1 / 2);
  const middle = center ?? (min && max ? between(min, max) : base && cap ? between(base, cap) : [0, 0, 0]);
  return transform.reduce((at, { translate }) => (translate ? add(at, translate) : at), middle);
}
