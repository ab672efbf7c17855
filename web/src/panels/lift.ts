// How much larger than they are heights are drawn: said, and changed.
import type { Choices } from '../state/choices';
import { kLifts } from '../scene/frame';
import { element } from '../text/element';

export function liftControl(choices: Choices): HTMLElement {
  const select = element('select', { id: 'lift', 'aria-label': 'How many times larger heights are drawn', title: 'How many times larger than they are heights are drawn' });
  select.append(...kLifts.map((times) => element('option', { value: String(times) }, `Heights ×${times}`)));
  select.addEventListener('change', () => choices.lift.set(Number(select.value)));
  choices.lift.watch((times) => (select.value = String(times)));
  return select;
}
