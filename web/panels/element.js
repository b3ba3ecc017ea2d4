// Elements made by code. Texts become text nodes: nothing that a server or a person writes is read
// as HTML.

const SVG = 'http://www.w3.org/2000/svg';

/**
 * An element: properties that start with `on` are listeners, `dataset` and `style` are merged, all
 * others attributes, true an empty one, false, null and undefined none; children are nodes or texts.
 */
export function element(tag, properties = {}, ...children) {
  return furnish(document.createElement(tag), properties, children);
}

/** The same in SVG. */
export function svg(tag, properties = {}, ...children) {
  return furnish(document.createElementNS(SVG, tag), properties, children);
}

function furnish(made, properties, children) {
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) made.addEventListener(name.slice(2), value);
    else if (name === 'dataset' || name === 'style') Object.assign(made[name], value);
    else if (value != null && value !== false) made.setAttribute(name, value === true ? '' : value);
  }
  made.append(...children.flat().filter((child) => child != null && child !== false));
  return made;
}
