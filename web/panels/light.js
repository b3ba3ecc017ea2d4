// The light's panel: keys laid out as seen from above, and the position in numbers.

import { numberText } from '../state/request.js';
import { recall, remember } from '../state/memory.js';
import { t } from '../words/words.js';
import { bindCopy } from './copy.js';
import { bindKeys } from './keys.js';
import { bindLightForm } from './light_form.js';

const part = (id) => document.getElementById(id);

export function mountLight(studio) {
  const { model } = studio;
  const buttons = [...document.querySelectorAll('[data-key]')];
  const showPosition = bindLightForm(part('light'), part('fault'), (light) => studio.moveLight(light));
  const letters = part('letters');

  function press(key) {
    if (key === 'Escape') model.change({ key: null, light: null });
    else model.change({ key, light: null });
  }

  function show() {
    const { key, light } = model.request;
    const on = key ?? (light ? 'typed' : 'Escape');
    for (const button of buttons) button.setAttribute('aria-pressed', button.dataset.key === on);
    part('pad').dataset.on = on;
    const lit = !key && !light && studio.light;
    buttons.find((button) => button.dataset.key === 'Escape').lastElementChild.textContent = t(lit ? 'light.own' : 'light.off');
    if (!part('light').contains(document.activeElement)) showPosition(studio.light);
  }

  letters.value = recall('letters') ?? 'picture';
  letters.addEventListener('change', () => remember('letters', letters.value));
  bindKeys(part('hand'), () => letters.value, press);
  for (const button of buttons) button.addEventListener('click', () => press(button.dataset.key));
  bindCopy(part('copy-light'), () => (studio.light ?? []).map(numberText).join(','));
  for (const event of ['show', 'world', 'source']) model.onFrame(event, show);
}

