// Tabs by the ARIA Authoring Practices: arrows, Home and End move, one tab is in the tab order.

import { recall, remember } from '../state/memory.js';

/** Makes the tabs work and gives the studio `openTab(id)`; panels hear `tab` with `studio.tab`. */
export function mountTabs(studio) {
  const list = document.querySelector('[role=tablist]');
  const tabs = [...list.querySelectorAll('[role=tab]')];
  const panelOf = (tab) => document.getElementById(tab.getAttribute('aria-controls'));

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
