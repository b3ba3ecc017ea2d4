// A request: the parameters of /render as a plain object, and what is sent for it; where it names a
// `model`, those of /still. Paths are relative to the page, which may be served below a prefix.

import { sizeOf } from './window.js';

/** What only a still has, but for `camera` and `scene`, which mean another thing there. */
const OF_STILLS = ['model', 'orbit', 'zoom', 'fov', 'studio', 'ground', 'background', 'variant', 'animation', 'time',
  'hide', 'up'];

/** The parameters that the page knows, in the order in which a URL names them. */
export const PARAMETERS = [...OF_STILLS, 'scene', 'key', 'light', 'camera', 'integrator', 'max_depth', 'ao_radius', 'seed',
  'width', 'height', 'samples', 'threshold', 'noise', 'denoise', 'budget_ms', 'max_rays', 'crop', 'transfer', 'exposure',
  'white_balance_kelvin'];

/** What asks for one ray a pixel, whatever else was asked for. */
export const ONE_RAY = { samples: 1, threshold: 0, noise: null, denoise: null, budget_ms: null, max_rays: null };

/** What the page opens with: the lamp is on, so that there is a shadow to ask about. */
export const FIRST = { scene: 'thesis', key: 'a' };

/** A scene of that name as it is opened. */
export const opened = (scene = FIRST.scene) => (scene === FIRST.scene ? FIRST : { scene });

const LISTS = ['light', 'crop', 'pixel', 'orbit', 'background'];
const TEXTS = ['scene', 'key', 'integrator', 'transfer', 'model', 'variant', 'hide'];
const LONGEST_TARGET = 4000; // the server refuses 4096 bytes and more

/** The request without what is undefined or null. */
export function tidy(request) {
  return Object.fromEntries(Object.entries(request).filter(([, value]) => value != null));
}

/** What draws a request's picture. */
export const routeOf = ({ model }) => (model ? 'still' : 'render');

/** The same of /render: a still as the scene that it is of. */
export function inScene(request, scene) {
  if (!request.model) return request;
  const [width, height] = sizeOf(request);
  const others = Object.entries(request).filter(([name]) => ![...OF_STILLS, 'camera'].includes(name));
  return { ...Object.fromEntries(others), scene, width, height };
}

const SAMPLING = ['samples', 'threshold', 'noise', 'budget_ms', 'max_rays'];

/**
 * A request as it is opened: a still that does not say how it is sampled has what /still takes then,
 * said, so that its rounds begin before anything is known of it.
 */
export function spelled(request) {
  if (!request.model || request.integrator) return request;
  const samples = SAMPLING.some((name) => request[name] != null) ? {} : { samples: 64 };
  return { ...request, integrator: 'path', ...samples };
}

/** What of a request says which scene it is of: its name; of a still all that makes its scene. */
export function subjectOf(request) {
  if (!request.model) return { scene: request.scene ?? FIRST.scene };
  const own = [...OF_STILLS, 'camera'].map((name) => [name, request[name] ?? null]);
  return { ...Object.fromEntries(own), scene: null, key: null, light: null };
}

/** A request as a query string without its question mark; what PARAMETERS does not name follows. */
export function queryOf(request) {
  const names = [...PARAMETERS, ...Object.keys(request).filter((name) => !PARAMETERS.includes(name))];
  return names.filter((name) => request[name] != null)
    .map((name) => `${name}=${encode(valueText(request[name]))}`).join('&');
}

// What may stand in a query stays readable (RFC 3986, 3.4). Brackets may not; curl reads them as
// ranges.
function encode(text) {
  return encodeURIComponent(text).replace(/%(2C|3A|2F)/gi, decodeURIComponent);
}

function valueText(value) {
  if (Array.isArray(value)) return value.map(numberText).join(',');
  return typeof value === 'object' ? JSON.stringify(value) : numberText(value);
}

/** The request that a query string writes. Values that are no JSON stay texts: the server judges. */
export function readQuery(query) {
  return Object.fromEntries([...new URLSearchParams(query)].map(([name, text]) => [name, readValue(name, text)]));
}

function readValue(name, text) {
  if (LISTS.includes(name)) return readNumbers(text) ?? text;
  if (TEXTS.includes(name) && !text.startsWith('{')) return text;
  try {
    return JSON.parse(text);
  } catch {
    return text;
  }
}

/** What fetch() takes for a request of `route`: a GET while its URL is short, else a POST. */
export function fetchable(route, request) {
  const query = queryOf(request);
  const path = query ? `${route}?${query}` : route;
  if (path.length < LONGEST_TARGET || request.model) return { path, init: {} };
  const headers = { 'Content-Type': 'application/json' };
  return { path: route, init: { method: 'POST', headers, body: JSON.stringify(tidy(request)) } };
}

/** The shell command that fetches the request's picture; `base` is the page's own address. */
export function curlLine(request, base) {
  const { path, init } = fetchable(routeOf(request), request);
  const url = quoted(new URL(path, base).href);
  const name = `tia${fileName(request)}.png`;
  return init.body ? `curl -o ${name} ${url} -d ${quoted(init.body)}` : `curl -o ${name} ${url}`;
}

/** What tells this picture's file from others: "-thesis-a", of a moment "-lamp-round-2-5s"; letters, digits and dashes only. */
export function fileName({ scene, key, light, model, turntable, time }) {
  const named = model ? `model-${model.slice(0, 8)}` : typeof scene === 'string' ? scene.slice(0, 40) : scene && 'scene';
  const parts = [named, key ?? (light && 'light'), turntable && 'turntable',
    !model && time != null && `${Number(Number(time).toFixed(3))}s`].filter(Boolean);
  return parts.map((part) => `-${part.replace(/[^\w-]+/g, '-')}`).join('');
}

/** In single quotes a POSIX shell takes every byte as it is. */
export function quoted(text) {
  return `'${text.replaceAll("'", "'\\''")}'`;
}

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i;

/** A typed number, a typographic minus included; NaN where the text is none. */
export function readNumber(text) {
  const plain = text.trim().replace(/^\u2212/, '-');
  return NUMBER.test(plain) ? Number(plain) : NaN;
}

/** Numbers written as "x,y,z", "x y z" or "[x, y, z]"; null where one is none. */
export function readNumbers(text) {
  const numbers = text.trim().replace(/^\[|\]$/g, '').trim().split(/\s*,\s*|\s+/).map(readNumber);
  return numbers.every(Number.isFinite) ? numbers : null;
}

/** A number as it stands in a URL, where a plus sign would be read as a space. */
export function numberText(number) {
  return String(number).replace('e+', 'e');
}
