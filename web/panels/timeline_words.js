// What the timeline's things are called.

import { valueAt, tokens } from '../state/scene_text.js';
import { lampPlace, placeOf } from '../state/tracks.js';
import { languageNow, numberWords, t, wordsOr } from '../words/words.js';

/** What a track moves: "Lamp", "Camera: looks at", "ball: colour". */
export function trackName(scene, target) {
  const place = placeOf(scene, target);
  if (place === lampPlace(scene)) return t('timeline.lamp');
  const steps = tokens(place);
  const owner = ownerOf(scene, steps);
  const last = steps.findLast((step) => !/^\d+$/.test(step));
  if (steps.length < 2 || last === steps[0]) return owner;
  return t('timeline.part', { owner, part: wordsOr(`timeline.field_${last}`, wordsOr(`scene.field_${last}`, last)) });
}

function ownerOf(scene, [list, at]) {
  if (list === 'camera') return t('timeline.camera');
  const one = valueAt(scene, `/${list}/${at}`);
  return one?.name ?? (one?.type ? `${one.type} ${Number(at) + 1}` : list === 'materials' ? at : list);
}

/** Seconds as they are told: two digits after the point at most. */
export const secondsWords = (time) => numberWords(Number(time.toFixed(2)), 6);

/** Seconds that change while they are seen: always two digits after the point. */
export const fixedWords = (time) =>
  time.toLocaleString(languageNow(), { minimumFractionDigits: 2, maximumFractionDigits: 2 });
