// What the page says, in the language chosen: one dictionary file a language, sections by panel.

import en from './en.js';
import { recall, remember } from '../state/memory.js';
import { numberText } from '../state/request.js';

export const LANGUAGES = ['en', 'vi'];
let language = 'en';
let dictionary = en;

/** Chooses the language: `wished`, else what was chosen here before, else the browser's, else English. */
export async function chooseLanguage(wished) {
  const spoken = (navigator.languages ?? []).map((tag) => tag.split('-')[0]);
  language = [wished, recall('language'), ...spoken].find((one) => LANGUAGES.includes(one)) ?? 'en';
  try {
    if (language !== 'en') dictionary = (await import(`./${language}.js`)).default;
  } catch (error) {
    console.warn('English instead:', error.message);
    language = 'en';
  }
  document.documentElement.lang = language;
}

/** Learns the words of a part of the page that is loaded later, from `NAME_LANGUAGE.js`. */
export async function learn(name) {
  dictionary = { ...dictionary, ...(await import(`./${name}_${language}.js`)).default };
}

export const languageNow = () => language;

/** Speaks another language from now on: the page is loaded anew, all that it shows is in its address. */
export function speak(other) {
  remember('language', other);
  location.reload();
}

/** The words called `name`, as "section.words", with `{x}` replaced by values.x. */
export function t(name, values = {}) {
  const [section, key] = name.split('.');
  const words = dictionary[section]?.[key];
  if (words === undefined) throw new Error(`no words called ${name}`);
  return words.replace(/\{(\w+)\}/g, (_, value) => values[value]);
}

/** Whether there are words of this name. */
export function has(name) {
  const [section, key] = name.split('.');
  return dictionary[section]?.[key] !== undefined;
}

/** These words, else `other`. */
export const wordsOr = (name, other) => (has(name) ? t(name) : other);

/** Gives every element below `root` its words: `data-t` as text, `data-t-label` as accessible name. */
export function dress(root = document) {
  for (const element of root.querySelectorAll('[data-t]')) element.textContent = t(element.dataset.t);
  for (const element of root.querySelectorAll('[data-t-label]'))
    element.setAttribute('aria-label', t(element.dataset.tLabel));
}

/** A number as this language writes it, with `digits` significant digits at most. */
export function numberWords(number, digits = 3) {
  return number.toLocaleString(language, { maximumSignificantDigits: digits });
}

/** A count with its thousands set apart. */
export function countWords(count) {
  return count.toLocaleString(language);
}

/** A duration with three digits that mean something. */
export function msWords(ms) {
  return `${numberWords(ms, ms < 1000 ? 3 : 4)} ms`;
}

/** Where the lamp is, in words, of a still where the eye is; `light` is its place, where that is known. */
export function lampWords({ key, light: wished, ...request }, light) {
  if (request.model) return stillWords(request);
  if (!key && !light) return t('light.isOff');
  const at = (wished ?? light)?.map((value) => numberText(Number(value.toPrecision(6)))).join(', ');
  if (!key) return t('light.isAt', { at });
  const place = has(`light.key_${key}`) ? t(`light.key_${key}`) : t('light.key', { key });
  return at ? t('light.isPlacedAt', { place, at }) : t('light.isPlaced', { place });
}

function stillWords({ camera, orbit: [azimuth, elevation] = [30, 20], studio = 'soft' }) {
  const light = t('model.litBy', { studio: wordsOr(`model.studio_${studio}`, studio) });
  const eye = camera != null ? t('model.throughCamera', { camera }) : t('model.from', { azimuth, elevation });
  return `${eye} ${light}`;
}
