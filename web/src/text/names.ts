// Names as they are shown: cut where they are long, and kept from turning the text around them.
import { element } from './element';

const kLongest = 64;

/** Cut between characters, not within one, and in the middle: names of one kind often differ at their ends. */
export function shorten(name: string, longest = kLongest): string {
  // No character is longer than two units, so this much holds all that could be kept.
  const characters = Array.from(name.slice(0, 2 * longest + 2));
  if (characters.length <= longest) return characters.join('') || '(no name)';
  const last = Math.floor((longest - 1) / 2);
  const end = last === 0 ? [] : Array.from(name.slice(-(2 * last + 2))).slice(-last);
  return `${characters.slice(0, longest - 1 - last).join('')}…${end.join('')}`;
}

/** For where there are no elements: letters from right to left stay between the marks. */
export function isolate(name: string, longest = kLongest): string {
  // A mark of its own in the name could end ours.
  return `\u2068${shorten(name, longest).replace(/[\u2066-\u2069]/g, '')}\u2069`;
}

export function nameElement(name: string): HTMLElement {
  const short = shorten(name);
  return element('bdi', short === name ? { class: 'name' } : { class: 'name', title: name }, short);
}
