// Tabs by the ARIA Authoring Practices: arrows, Home and End move, one tab is in the tab order.

import { recall, remember } from '../state/memory.js';
import { t } from '../words/words.js';
import { element } from './element.js';
import { later } from './later.js';

/** The panels that index.html lists, in its order: [{ name, mount(studio, panel) }]. */
export function loadPanels() {
  return Promise.all([...document.querySelectorAll('[data-panel]')].map(async ({ href, dataset: { panel: name } }) =>
    ({ name, mount: href ? (await import(href)).default : later(name) })));
}

/** Makes a tab of each panel and gives the studio `openTab(id)`; panels hear `tab` with `studio.tab`. */
export function mountTabs(studio, panels) {
  const list = document.querySelector('[role=tablist]');
  const tabs = panels.map(({ name }) => element('button',
    { type: 'button', role: 'tab', id: `tab-${name}`, 'aria-controls': `panel-${name}` }, t(`${name}.tab`)));
  const panelOf = (tab) => document.getElementById(tab.getAttribute('aria-controls'));
  list.append(...tabs);
  for (const { name, mount } of panels) mount(studio, sectionOf(name, list.parentElement));

  studio.openTab = (id) => {
    const wanted = tabs.find((tab) => tab.id === id) ?? tabs[0];
    for (const tab of tabs) {
      const on = tab === wanted;
      tab.setAttribute('aria-selected', on);
      tab.tabIndex = on ? 0 : -1;
      panelOf(tab).hidden = !on;
    }
    remember('tab', wanted.id, 'sessionStorage');
    studio.tab = wanted.id;
    studio.model.tell('tab');
  };

  list.addEventListener('keydown', (event) => {
    const at = tabs.indexOf(document.activeElement);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: -1 }[event.key];
    if (at < 0 || to === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const tab = tabs.at(to % tabs.length);
    tab.focus();
    studio.openTab(tab.id);
  });
  for (const tab of tabs) tab.addEventListener('click', () => studio.openTab(tab.id));
  studio.openTab(recall('tab', 'sessionStorage'));
}

// A panel's part of the page, below its tabs; the first one's has its content there already.
function sectionOf(name, panels) {
  return document.getElementById(`panel-${name}`) ?? panels.appendChild(
    element('section', { role: 'tabpanel', id: `panel-${name}`, 'aria-labelledby': `tab-${name}` }));
}
