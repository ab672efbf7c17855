// Finds a bee by its id.
import type { Choices } from '../state/choices';
import { element } from '../text/element';
import { nameElement } from '../text/names';
import { capitalised, counted, nounOfAll, oneOf } from '../text/noun';
import type { Actions, Shown } from './shown';

const kOffered = 12;

interface Offer {
  swarm: number;
  bee: number;
}

export function searchBox(all: Shown[], choices: Choices, actions: Actions): HTMLElement {
  const noun = nounOfAll(all);
  const input = element('input', {
    type: 'search',
    id: 'search',
    role: 'combobox',
    placeholder: `Find ${oneOf(noun)}`,
    'aria-label': `Find ${oneOf(noun)} by its id`,
    'aria-expanded': 'false',
    'aria-controls': 'search-offers',
    'aria-autocomplete': 'list',
    autocomplete: 'off',
    spellcheck: 'false',
  });
  const list = element('ul', { id: 'search-offers', role: 'listbox', 'aria-label': `${capitalised(noun.several)} found`, hidden: '' });
  const none = element('p', { class: 'hidden-text', role: 'status' });
  const box = element('div', { class: 'search' }, input, list, none);
  let offers: Offer[] = [];
  let active = -1;
  let waiting = 0;

  const close = (): void => {
    list.hidden = true;
    input.setAttribute('aria-expanded', 'false');
    input.removeAttribute('aria-activedescendant');
    active = -1;
  };
  const choose = (offer: Offer): void => {
    input.value = '';
    close();
    actions.select({ ...offer, other: null, place: null }, { fly: true });
  };
  const activate = (place: number): void => {
    active = place;
    [...list.children].forEach((item, i) => item.setAttribute('aria-selected', String(i === place)));
    if (place < 0) return;
    input.setAttribute('aria-activedescendant', `offer-${place}`);
    list.children[place].scrollIntoView({ block: 'nearest' });
  };
  const offer = (): void => {
    clearTimeout(waiting);
    waiting = 0;
    offers = find(all, input.value);
    list.replaceChildren(...offers.map((one, i) => offerElement(all, one, i)));
    const asked = input.value.trim() !== '';
    none.textContent = asked ? offers.length === 0 ? `No ${noun.one} found` : `${counted(offers.length, noun)} found` : '';
    if (asked && offers.length === 0) list.append(element('li', { class: 'quiet', role: 'option', 'aria-disabled': 'true' }, `No such ${noun.one}`));
    list.hidden = !asked;
    input.setAttribute('aria-expanded', String(asked));
    activate(offers.length > 0 ? 0 : -1);
  };

  input.addEventListener('input', () => {
    // A million names take a while: not at every letter of a quick hand.
    clearTimeout(waiting);
    waiting = window.setTimeout(offer, all[0].swarm.head.count > 50000 ? 150 : 0);
  });
  input.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      if (list.hidden) input.blur();
      close();
      input.value = '';
    } else if (event.key === 'Enter') {
      // What is offered may be for fewer letters than there are by now.
      if (list.hidden || active < 0 || waiting !== 0) offer();
      if (active >= 0) choose(offers[active]);
    } else if ((event.key === 'ArrowDown' || event.key === 'ArrowUp') && offers.length > 0) {
      event.preventDefault();
      const step = event.key === 'ArrowDown' ? 1 : -1;
      activate((active + step + offers.length) % offers.length);
    } else {
      return;
    }
    event.stopPropagation();
  });
  list.addEventListener('pointerdown', (event) => {
    const item = (event.target as Element).closest<HTMLElement>('[data-offer]');
    if (!item) return;
    event.preventDefault();
    choose(offers[Number(item.dataset.offer)]);
  });
  input.addEventListener('blur', close);
  choices.selected.watch(() => close());
  return box;
}

function find(all: Shown[], text: string): Offer[] {
  const offers: Offer[] = [];
  const seen = new Set<string>();
  for (const { swarm, index } of all) {
    for (const bee of swarm.names.find(text, swarm.head.count, kOffered)) {
      const name = swarm.names.of(bee);
      if (all.length > 1 && seen.has(name)) continue;
      seen.add(name);
      offers.push({ swarm: index, bee });
    }
  }
  return offers.slice(0, kOffered);
}

function offerElement(all: Shown[], { swarm, bee }: Offer, place: number): HTMLElement {
  return element(
    'li',
    { role: 'option', id: `offer-${place}`, 'data-offer': String(place), 'aria-selected': 'false' },
    nameElement(all[swarm].swarm.names.of(bee)),
  );
}
