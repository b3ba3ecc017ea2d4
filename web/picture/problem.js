// What went wrong, in words: the server's problem documents (RFC 9457) and everything short of one.

import { t } from '../words/words.js';

/** A request that gave no picture; `status` 0 where no answer came at all. */
export class Problem extends Error {
  constructor({ status = 0, title, detail, errors, instance = '' }, retryAfter = null) {
    super(title);
    const faults = Array.isArray(errors) ? errors.filter(Boolean) : [];
    Object.assign(this, { status, title, errors: faults, instance, retryAfter });
    this.detail = String(detail ?? '');
  }
}

/** The problem that a response with an error status tells. */
export async function readProblem(response) {
  const { status, statusText, headers } = response;
  const title = t('trouble.answered', { status, statusText }).trim();
  const document = headers.get('Content-Type')?.startsWith('application/problem+json')
    ? await response.json().catch(ignored)
    : {};
  return new Problem({ title, ...document, status }, headers.get('Retry-After'));
}

// A document that is none; but who gives up a request wants to hear nothing.
function ignored(error) {
  if (error.name === 'AbortError') throw error;
  return {};
}

/** The problem that a failed fetch tells. */
export function unanswered(error) {
  return error.name === 'TimeoutError'
    ? new Problem({ title: t('trouble.late') })
    : new Problem({ title: t('trouble.unreachable') });
}

/** A problem as { title, lines, next, retry, wait }: what happened, what to do, by whom, after how many s; `stays`: there is a picture. */
export function problemWords(problem, stays = true) {
  const { status, title, detail, errors, retryAfter } = problem;
  const repeats = errors.some(({ pointer }) => pointer && detail.startsWith(`${pointer}:`));
  const lines = [repeats ? '' : detail, ...errors.map(faultWords)].filter(Boolean);
  const retry = status === 0 || status === 408 || status === 429 || status >= 500;
  const wait = retry && /^\d+$/.test(retryAfter ?? '') ? Number(retryAfter) : 0;
  return { title, lines, next: nextStep(problem, retry, wait, stays), retry, wait };
}

function nextStep({ status, instance }, retry, wait, stays) {
  const log = status === 500 && instance ? t('trouble.log', { instance }) : '';
  const step = status === 0 ? t('trouble.check') : !retry ? t('trouble.change')
    : wait ? t('trouble.wait', { wait }) : t('trouble.again');
  return [step, stays ? t('trouble.stays') : t('trouble.others'), log].filter(Boolean).join(' ');
}

/** One fault of a problem document in words, by its place. */
export function faultWords(fault) {
  const place = String(fault.pointer ?? '').split('/').slice(1).map(unescape).join(' \u203a ');
  return `${place || t('trouble.theRequest')}: ${faultReason(fault)}`;
}

/** What is wrong there, what is allowed, what is near. */
export function faultReason({ got, allowed, nearest }) {
  const parts = [
    got !== undefined && t('trouble.got', { value: valueWords(got) }),
    allowed !== undefined && t('trouble.allowed', { value: listWords(allowed) }),
    nearest != null && t('trouble.nearest', { value: valueWords(nearest) }),
  ];
  return parts.filter(Boolean).join('; ');
}

function unescape(token) {
  return token.replaceAll('~1', '/').replaceAll('~0', '~');
}

function listWords(allowed) {
  return Array.isArray(allowed) ? allowed.map(valueWords).join(', ') : valueWords(allowed);
}

function valueWords(value) {
  const text = typeof value === 'string' ? value : JSON.stringify(value);
  return text.length > 120 ? `${text.slice(0, 120)}\u2026` : text;
}
