// Sentences about a picture's light.

import { numberText } from '../state/request.js';
import { has, t } from './words.js';

/** Where the lamp is, in words; `light` is its place, where that is known. */
export function lampWords({ key, light: wished }, light) {
  if (!key && !light) return t('light.isOff');
  const at = (wished ?? light)?.map((value) => numberText(Number(value.toPrecision(6)))).join(', ');
  if (!key) return t('light.isAt', { at });
  const place = has(`light.key_${key}`) ? t(`light.key_${key}`) : t('light.key', { key });
  return at ? t('light.isPlacedAt', { place, at }) : t('light.isPlaced', { place });
}
