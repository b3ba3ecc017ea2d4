// The controls of comparing: what with, how, and where the line is.

import { aboutOf, featureNames, isFeature } from '../picture/integrators.js';
import { windowOf } from '../state/window.js';
import { t, wordsOr } from '../words/words.js';
import { element } from './element.js';

const FACTORS = [1, 4, 16];

/**
 * The form: `state` as { partner, mode, factor, share }, `choose(partner)`, `kept(picture)`,
 * `tell(words)`, `slide(share)`; it calls `keep`, `clear`, `goBack`, `change` and `slide(share)`.
 */
export function compareForm({ keep, clear, goBack, change, slide }) {
  const state = { partner: 'none', mode: 'slider', factor: 1, share: 0.5 };
  const button = (name, press) => element('button', { type: 'button', onclick: press }, t(`compare.${name}`));
  const about = element('p', { class: 'note', id: 'compare-about' });
  const told = element('p', { class: 'told', role: 'status' });
  const range = element('input', { type: 'range', min: 0, max: 1, step: 'any',
    oninput: () => slideTo(range.valueAsNumber) });
  const card = element('div', { class: 'kept', hidden: true });
  const partners = choices('partner', ['none', 'kept', ...featureNames()],
    (name) => wordsOr(`compare.${name}`, name));
  const modes = choices('mode', ['slider', 'difference'], (name) => t(`compare.${name}`));
  const factors = choices('factor', FACTORS, (factor) => t('compare.times', { factor }));
  const line = element('label', { class: 'wide' }, t('compare.line'), range);

  function choices(name, values, words) {
    const radios = values.map((value) => element('input', { type: 'radio', name: `compare-${name}`, value,
      onchange: () => set({ [name]: value }) }));
    const node = element('fieldset', { class: `choices ${name}` }, element('legend', {}, t(`compare.${name}s`)),
      radios.map((radio, i) => element('label', {}, radio, words(values[i]))));
    return { node, radios };
  }

  function set(patch) {
    Object.assign(state, patch);
    draw();
    change();
  }

  function draw() {
    const { partner, mode, factor, share } = state;
    for (const [{ radios }, value] of [[partners, partner], [modes, mode], [factors, factor]])
      for (const radio of radios) radio.checked = radio.value === String(value);
    partners.radios[1].disabled = card.hidden;
    const differs = partner === 'kept' && mode === 'difference';
    modes.node.hidden = partner !== 'kept';
    factors.node.hidden = !differs;
    line.hidden = partner === 'none' || differs;
    range.value = share;
    range.setAttribute('aria-valuetext', t('compare.share', { share: Math.round(share * 100) }));
    about.textContent = isFeature(partner) ? wordsOr(`compare.about_${partner}`, aboutOf(partner)) : '';
  }

  function slideTo(share) {
    state.share = share;
    draw();
    slide(share);
  }

  function kept(picture) {
    card.hidden = !picture;
    if (!picture) return card.replaceChildren();
    const { width, height } = windowOf(picture.request);
    card.replaceChildren(
      element('img', { src: picture.image.src, alt: t('compare.a'), width: 96,
        height: Math.round((96 * height) / width) }),
      element('p', {}, picture.words),
      element('div', { class: 'row wrap' }, button('goBack', goBack), button('clear', clear)));
  }

  draw();
  return {
    state, kept,
    nodes: [button('keep', keep), card, partners.node, about, modes.node, factors.node, line, told],
    choose: (partner) => set({ partner }),
    tell: (words) => (told.textContent = words),
    slide: slideTo,
  };
}
