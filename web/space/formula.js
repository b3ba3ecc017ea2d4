// Formulas of time, to draw where they lead: the server's language (core/formulas), with this browser's functions.

const FUNCTIONS = ['sqrt', 'abs', 'min', 'max', 'floor', 'exp', 'log', 'sin', 'cos', 'tan', 'asin', 'acos', 'atan', 'atan2',
  'sinh', 'cosh', 'tanh'];
const WORDS = /\s*(?:(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)|([A-Za-z_]\w*)|(.))/gy;
const SIGNS = {
  '+': (a, b) => a + b, '-': (a, b) => a - b, '*': (a, b) => a * b, '/': (a, b) => a / b, '^': (a, b) => a ** b,
};

/** What a formula comes to, as a function of { name: number }; null where it is none. */
export function formula(text) {
  const words = [...text.trimEnd().matchAll(WORDS)].map(([, number, name, sign]) => ({ number, name, sign }));
  let at = 0;
  const takes = (sign) => words[at]?.sign === sign && (at += 1) > 0;
  const need = (sign) => {
    if (!takes(sign)) throw new SyntaxError(text);
  };
  const joined = (part, signs) => {
    let left = part();
    for (let sign; (sign = words[at]?.sign) && signs.includes(sign);) {
      at += 1;
      const [a, b, act] = [left, part(), SIGNS[sign]];
      left = (values) => act(a(values), b(values));
    }
    return left;
  };
  const sum = () => joined(product, '+-');
  const product = () => joined(signed, '*/');
  function signed() {
    if (!takes('-')) return power();
    const part = signed();
    return (values) => -part(values);
  }
  function power() {
    const base = operand();
    if (!takes('^')) return base;
    const exponent = signed();
    return (values) => SIGNS['^'](base(values), exponent(values));
  }
  function operand() {
    if (takes('(')) return closed(sum());
    const { number, name } = words[at++] ?? {};
    if (number) return () => Number(number);
    if (FUNCTIONS.includes(name)) return call(Math[name]);
    if (!name) throw new SyntaxError(text);
    return (values) => (name === 'pi' ? Math.PI : values[name] ?? NaN);
  }
  const closed = (part) => (need(')'), part);
  function call(act) {
    need('(');
    const parts = [sum()];
    while (takes(',')) parts.push(sum());
    need(')');
    if (parts.length !== act.length) throw new SyntaxError(text);
    return (values) => act(...parts.map((part) => part(values)));
  }
  try {
    const whole = sum();
    return at === words.length ? whole : null;
  } catch (error) {
    if (error instanceof SyntaxError) return null;
    throw error;
  }
}
