// Source: RFC 7396, JSON Merge Patch, section 2.

/** `target` as `patch` leaves it. What is no object patches nothing of a scene: it is a lamp's place. */
export function mergePatch(target, patch) {
  if (!isObject(patch)) return target;
  const merged = { ...(isObject(target) ? target : {}) };
  for (const [name, value] of Object.entries(patch)) {
    if (value === null) delete merged[name];
    else merged[name] = isObject(value) ? mergePatch(merged[name], value) : value;
  }
  return merged;
}

function isObject(value) {
  return value !== null && typeof value === 'object' && !Array.isArray(value);
}
