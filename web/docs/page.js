// The page of documentation. It knows no request, field or problem: all of it is drawn from the
// server's OpenAPI document.

import { element } from '../panels/element.js';
import { problemWords } from '../picture/problem.js';
import { fetchJson } from '../picture/server.js';
import { t } from '../words/words.js';
import { link, section } from './parts.js';
import { sectionsOf } from './sections.js';

const main = document.querySelector('main');

async function begin() {
  main.replaceChildren(element('p', { class: 'note', role: 'status' }, 'Reading openapi.json \u2026'));
  const openapi = await fetchJson('openapi.json').catch(tell);
  if (openapi) draw(openapi);
}

function draw(openapi) {
  const { description, version } = openapi.info;
  document.getElementById('about').replaceChildren(
    ...[...description.split('\n\n'), `Version ${version}.`].map((text) => element('p', {}, text)));
  const sections = sectionsOf(openapi);
  document.querySelector('nav').replaceChildren(element('h2', {}, 'Contents'), contents(sections));
  main.replaceChildren(...sections.map(({ id, title, inside }) => section(id, 'h2', title, inside)));
  if (location.hash) location.replace(location.hash); // its place is there only now
}

const contents = (sections) =>
  element('ul', {}, sections.map(({ id, title, entries = [] }) =>
    element('li', {}, link(id, title), entries.length > 0 &&
      element('ul', {}, entries.map(([to, words]) => element('li', {}, link(to, words)))))));

function tell(problem) {
  const { title, lines } = problemWords(problem);
  main.replaceChildren(element('div', { class: 'trouble' },
    element('div', { id: 'problem', role: 'alert' },
      element('strong', {}, title), lines.map((line) => element('p', {}, line))),
    element('button', { type: 'button', id: 'retry', onclick: begin }, t('trouble.retry'))));
}

begin();
