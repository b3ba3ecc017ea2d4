// The list of what is wrong with the scene's text: each fault leads to its place, and where a
// name that is known is near, puts it there.

import { faultReason } from '../picture/problem.js';
import { t } from '../words/words.js';
import { element } from './element.js';

/** Fills `list` with faults; `jump(fault)` goes there, `fix(fault)` mends it. */
export function showFaults(list, faults, { jump, fix }) {
  list.replaceChildren(...faults.map((fault) => {
    const { line, column, error } = fault;
    const place = t('scene.place', { line, column });
    return element('li', {},
      element('button', { type: 'button', class: 'fault-place', onclick: () => jump(fault) }, place), ' ',
      element('span', {}, wordsOf(fault)), ' ',
      fault.fix && element('button', { type: 'button', class: 'fault-fix', onclick: () => fix(fault) },
        t('scene.useNearest', { name: error.nearest })));
  }));
}

function wordsOf({ reason, got, error, missing }) {
  if (reason) return t(`scene.fault_${reason}`, { got });
  if (missing === null) return faultReason(error);
  return `${t('scene.missing', { name: missing })}; ${faultReason(error)}`;
}
