// Which bees to show: all, only those at risk, only one conflict group.
import type { Choices } from '../state/choices';
import { element } from '../text/element';
import { formatBelow, formatCount } from '../text/numbers';
import { counted, nounOf, nounOfAll } from '../text/noun';
import type { Shown } from './shown';

const kOffered = 200;

export function filterControls(all: Shown[], choices: Choices): HTMLElement {
  const moving = all.some(({ swarm }) => swarm.kind === 'recording');
  const { several } = nounOfAll(all);
  const onlyRisk = element('input', { type: 'checkbox', id: 'only-at-risk' });
  const risk = element(
    'label',
    { class: 'check', for: 'only-at-risk', title: moving ? `Only ${several} that are in conflict at some time` : `Only ${several} that are at risk` },
    onlyRisk,
    'Only at risk',
  );
  onlyRisk.addEventListener('change', () => {
    choices.filter.set({ ...choices.filter.value, atRiskOnly: onlyRisk.checked });
  });

  const groups = element('select', { id: 'group', 'aria-label': 'Conflict group to show' });
  groups.append(element('option', { value: '' }, 'All groups'));
  for (const shown of all) {
    const into = shown.label ? element('optgroup', { label: shown.label }) : groups;
    shown.company.groups.list.slice(0, kOffered).forEach((group, place) => {
      const text = `Group ${formatCount(group.number)}: ${counted(group.bees.length, nounOf(shown.swarm.head))}, ${formatBelow(group.closest_m, shown.swarm.head.threshold_m, 3)}`;
      into.append(element('option', { value: `${shown.index}/${place}` }, text));
    });
    const more = shown.company.groups.list.length - kOffered;
    if (more > 0) into.append(element('option', { disabled: '' }, `and ${formatCount(more)} smaller ones`));
    if (into !== groups) groups.append(into);
  }
  groups.addEventListener('change', () => {
    const [swarm, place] = groups.value.split('/').map(Number);
    choices.filter.set({
      ...choices.filter.value,
      group: groups.value === '' ? null : { swarm, place },
    });
  });

  // A group beyond the list may be chosen by a bee of it.
  const extra = element('option', { hidden: '' });
  groups.append(extra);
  choices.filter.watch(({ atRiskOnly, group }) => {
    onlyRisk.checked = atRiskOnly;
    const value = group ? `${group.swarm}/${group.place}` : '';
    if (group && group.place >= kOffered) {
      extra.value = value;
      extra.textContent = `Group ${formatCount(all[group.swarm].company.groups.list[group.place].number)}`;
    }
    groups.value = value;
  });
  return element('div', { class: 'filter', role: 'group', 'aria-label': 'Whom to show' }, risk, groups);
}
