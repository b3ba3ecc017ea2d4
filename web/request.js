// From what is wanted to what is sent. A state is {} (unlit), { key: 'a' } or { light: [x, y, z] }.

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** A typed number, a typographic minus included; NaN where the text is none. */
export function readNumber(text) {
  const plain = text.trim().replace(/^\u2212/, '-');
  return NUMBER.test(plain) ? Number(plain) : NaN;
}

/** A position written as "x,y,z", "x y z" or "[x, y, z]"; null where the text is none. */
export function readLight(text) {
  const parts = text.trim().replace(/^\[|\]$/g, '').trim().split(/\s*,\s*|\s+/);
  const light = parts.map(readNumber);
  return light.length === 3 && light.every(Number.isFinite) ? light : null;
}

/** A number as it stands in a URL, where a plus sign would be read as a space. */
export function numberText(number) {
  return String(number).replace('e+', 'e');
}

/** A position as it is sent and copied: "x,y,z", or nothing for none. */
export function lightText(light) {
  return (light ?? []).map(numberText).join(',');
}

/** The path of a state's picture, relative to the page. */
export function renderPath({ key, light }) {
  if (key) return `render?key=${encodeURIComponent(key)}`;
  if (light) return `render?light=${lightText(light)}`;
  return 'render';
}

/** The shell command that fetches a state's picture; `base` is the page's own address. */
export function curlLine(state, base) {
  const name = state.key ? `tia-${state.key}` : state.light ? 'tia-light' : 'tia';
  return `curl -o ${name}.png '${new URL(renderPath(state), base).href}'`;
}
