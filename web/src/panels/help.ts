// What one can do here, and with which keys.
import type { Noun } from '../data/page';
import { oneOf } from '../text/noun';
import { button, element } from '../text/element';

function keysFor(noun: Noun): [string, string][] {
  return [
    ['/', `find ${oneOf(noun)}`],
    ['1, 2, …, 9', 'the closest pair, the second closest, …'],
    ['n, p', 'the next closest pair or conflict, and back'],
    ['← → ↑ ↓', 'turn (with Shift: move)'],
    ['+ −', 'nearer, farther'],
    ['r', 'all of the swarm again'],
    ['t, s', 'from the top, from the side'],
    ['f', `fly to the selected ${noun.one}`],
    ['o', 'only those at risk, or all'],
    ['g', `only the group of the selected ${noun.one}, or all`],
    ['m', `measure: click two ${noun.several}, or places on the floor`],
    ['c', `what colours tell: the nearest ${noun.one}, height, speed, conflict group`],
    ['d', 'dark or light'],
    ['Escape', `no ${noun.one} selected, all groups; measuring ends`],
    ['?', 'this help'],
  ];
}

const kTimeKeys: [string, string][] = [
  ['Space', 'play, pause'],
  [', .', 'a step back, a step on'],
  ['[ ]', 'to the conflict before, to the next one'],
  ['< >', 'slower, faster'],
  ['Home End', 'to the beginning, to the end'],
  ['l', 'trails'],
  ['v', 'velocity vectors'],
];

function keyTable(keys: [string, string][]): HTMLElement {
  return element(
    'table',
    { class: 'keys' },
    element('thead', { class: 'hidden-text' }, element('tr', {}, element('th', { scope: 'col' }, 'Key'), element('th', { scope: 'col' }, 'What it does'))),
    element(
      'tbody',
      {},
      ...keys.map(([key, what]) =>
        element('tr', {}, element('th', { scope: 'row' }, element('kbd', {}, key)), element('td', {}, what)),
      ),
    ),
  );
}

/** Where it is known what the planner of the fleet said. */
function fleetHelp(noun: Noun): HTMLElement {
  return element(
    'p',
    {},
    `Of the selected ${noun.one} the small ring is where its planner has it, and the ball around that its tube: it is not farther ` +
      'from there while it keeps its contract. Lines lead along all branches on which it may be, each to a stop; the hull of ' +
      `them all is its claim, of which others keep clear. A large ring is around ${oneOf(noun)} that is out of its contract.`,
  );
}

/** Without heights there is one view, which does not turn. */
function keysOf(flat: boolean, noun: Noun): [string, string][] {
  const keys = keysFor(noun);
  if (!flat) return keys;
  return keys.filter(([key]) => key !== 't, s').map(([key, what]) => (key.startsWith('←') ? [key, 'move'] : [key, what]));
}

export function helpDialog({ moving, fleet, flat, noun }: { moving: boolean; fleet: boolean; flat: boolean; noun: Noun }): HTMLDialogElement {
  const dialog = element('dialog', { class: 'help', 'aria-labelledby': 'help-heading' });
  dialog.append(
    element(
      'div',
      { class: 'help-head' },
      element('h2', { id: 'help-heading' }, 'Help'),
      button('Close', {}, () => dialog.close()),
    ),
    element(
      'p',
      {},
      flat
        ? 'Drag to move, wheel or pinch to zoom. The input has no heights: all is seen from above. '
        : 'Drag to turn, with the right button or two fingers to move, wheel or pinch to zoom. ',
      `Click ${oneOf(noun)} to see its numbers. `,
      'Red diamonds are at risk and always drawn on top; lines join those who are too close. ',
      `The ${flat ? 'circle' : 'sphere or cylinder'} around the selected ${noun.one} is what counts as too close to it.`,
    ),
    ...(fleet ? [fleetHelp(noun)] : []),
    element('h3', {}, 'Keys'),
    keyTable(keysOf(flat, noun)),
  );
  if (moving) dialog.append(element('h3', {}, 'Time'), keyTable(kTimeKeys));
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
