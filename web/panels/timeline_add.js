// What is given keys: chosen by name, or moved or changed just now.

import { changedPlace } from '../state/keys.js';
import { MOST_OBJECTS } from '../studio/timeline.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { secondsWords, trackName } from './timeline_words.js';

/** The form as { node, draw() }; `tell(words)` says what it comes to. */
export function addForm(studio, timeline, tell) {
  const what = element('select', { onchange: () => (timeline.thing = what.value) });
  const adder = element('button', { type: 'button', class: 'add', onclick: add });
  const around = element('button', { type: 'button', onclick: goAround }, t('timeline.around'));
  const node = element('div', { class: 'add-form' },
    element('label', {}, element('span', {}, t('timeline.what')), what), adder, around);

  function add() {
    const done = timeline.addFor(timeline.thing);
    tell(done === null ? t('timeline.lampOff') : done ? added(timeline) : t('timeline.broken'));
  }

  function goAround() {
    const done = timeline.around();
    tell(done === null ? t(studio.light ? 'timeline.onAxis' : 'timeline.lampOff') : done ? '' : t('timeline.broken'));
  }

  function draw() {
    const things = timeline.things.map(({ place, ...one }) => ({ ...one, ...(place && { name: trackName(timeline.scene, place) }) }));
    const all = JSON.stringify(things);
    if (what.dataset.all !== all) {
      what.dataset.all = all;
      what.replaceChildren(...things.map(({ id, name }) =>
        element('option', { value: id }, name ?? t(`timeline.${id}`))));
    }
    if (!things.some(({ id }) => id === timeline.thing)) timeline.thing = 'lamp';
    what.value = timeline.thing;
    const words = t('timeline.add', { at: secondsWords(timeline.time) });
    if (adder.textContent !== words) adder.textContent = words;
  }

  follow(studio, timeline);
  return { node, draw };
}

/** What is told of a key that has come. */
export const added = (timeline) => t('timeline.added', { at: secondsWords(timeline.time) });

// What somebody has moved, or else changed, is what they mean.
function follow(studio, timeline) {
  const { model } = studio;
  let before = null; // of the same scene
  const look = () => {
    const now = { title: model.source?.title, places: placesOf(studio), scene: shortened(model.source) };
    const same = before !== null && before.title === now.title;
    const moved = same && Object.keys(now.places).find((id) => id in before.places && now.places[id] !== before.places[id]);
    const changed = same && !moved && changedPlace(before.scene, now.scene);
    if (moved) timeline.thing = moved;
    else if (changed) timeline.mean(changed);
    before = now;
  };
  look();
  for (const event of ['want', 'source']) model.on(event, look);
}

const shortened = (scene) => scene && { ...scene, ...(scene.objects && { objects: scene.objects.slice(0, MOST_OBJECTS) }) };

// Where hands have put things, a text for each of them.
function placesOf({ model, held: { values: held } }) {
  const { light, key, camera } = model.request;
  const heldAt = (start) => Object.keys(held).filter((place) => place.startsWith(start)).map((place) => held[place]);
  const objects = (model.source?.objects ?? []).slice(0, MOST_OBJECTS).map(({ center, transform }, i) =>
    [`object-${i}`, [center, transform, heldAt(`/objects/${i}/`)]]);
  const all = [['lamp', [light, key, heldAt('/key_light/'), heldAt('/lights/')]], ['camera', [camera, heldAt('/camera/')]], ...objects];
  return Object.fromEntries(all.map(([id, places]) => [id, JSON.stringify(places)]));
}
