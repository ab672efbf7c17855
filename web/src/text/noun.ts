// What is recorded, as people call it: bees, drones, animals, aircraft. Where swarms that are compared are of several kinds, bees.
import type { Noun } from '../data/page';
import { formatCount } from './numbers';

const kBee: Noun = { one: 'bee', several: 'bees' };

export function nounOf(head: { noun?: Noun }): Noun {
  return head.noun ?? kBee;
}

export function nounOfAll(all: { swarm: { head: { noun?: Noun } } }[]): Noun {
  const [first, ...others] = all.map(({ swarm }) => nounOf(swarm.head));
  return first && others.every(({ one }) => one === first.one) ? first : kBee;
}

/** a drone, an animal */
export function oneOf({ one }: Noun): string {
  return `${/^[aeiou]/.test(one) ? 'an' : 'a'} ${one}`;
}

/** 1 drone, 1,234 drones */
export function counted(count: number, { one, several }: Noun): string {
  return `${formatCount(count)} ${count === 1 ? one : several}`;
}

export function capitalised(word: string): string {
  return word.charAt(0).toUpperCase() + word.slice(1);
}
