// What went wrong, in words: the server's problem documents (RFC 9457) and everything short of one.

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
  const title = `The server answered ${status} ${statusText}`.trim();
  const document = headers.get('Content-Type')?.startsWith('application/problem+json')
    ? await response.json().catch(() => ({}))
    : {};
  return new Problem({ title, ...document, status }, headers.get('Retry-After'));
}

/** The problem that a failed fetch tells. */
export function unanswered(error) {
  return error.name === 'TimeoutError'
    ? new Problem({ title: 'The server did not answer in time' })
    : new Problem({ title: 'The server cannot be reached' });
}

/** A problem as { title, lines, next, retry }: what happened, its faults, what to do, by whom. */
export function problemWords(problem) {
  const { status, title, detail, errors } = problem;
  const repeats = errors.some(({ pointer }) => pointer && detail.startsWith(`${pointer}:`));
  const lines = [repeats ? '' : detail, ...errors.map(faultWords)].filter(Boolean);
  const retry = status === 0 || status === 408 || status === 429 || status >= 500;
  return { title, lines, next: nextStep(problem, retry), retry };
}

function nextStep({ status, retryAfter, instance }, retry) {
  if (status === 0) return 'Check that tia is running, then try again. The last picture stays.';
  if (!retry) return 'Change the request and send it again. The last picture stays.';
  const wait = /^\d+$/.test(retryAfter ?? '') ? `Wait ${retryAfter} s, then try again.` : 'Try again.';
  const log = status === 500 && instance ? ` The server's log tells more under ${instance}.` : '';
  return `${wait} The last picture stays.${log}`;
}

function faultWords({ pointer = '', got, allowed, nearest }) {
  const place = String(pointer).split('/').slice(1).map(unescape).join(' \u203a ') || 'the request';
  const parts = [
    got !== undefined && `got ${valueWords(got)}`,
    allowed !== undefined && `allowed: ${listWords(allowed)}`,
    nearest !== undefined && nearest !== null && `nearest: ${valueWords(nearest)}`,
  ];
  return `${place}: ${parts.filter(Boolean).join('; ')}`;
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
