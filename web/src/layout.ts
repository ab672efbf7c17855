// The page's frame: a head, the swarms with what steers them, and the panels beside.
import type { Page } from './data/page';
import type { Choices } from './state/choices';
import { button, element } from './text/element';
import { nameElement } from './text/names';

export interface Layout {
  page: HTMLElement;
  toolbar: HTMLElement;
  stages: HTMLElement;
  column: HTMLElement;
  panels: HTMLElement;
}

export function layout(page: Page, choices: Choices, help: () => void, copyLink: () => Promise<boolean>): Layout {
  const title = element('h1', {});
  page.swarms.forEach(({ title: name }, i) => title.append(...(i > 0 ? [' → '] : []), nameElement(name)));
  const theme = button('', { class: 'quiet-button', title: 'Dark or light (d)' }, () => toggleTheme(choices));
  choices.theme.watch((name) => {
    theme.textContent = name === 'dark' ? 'Light' : 'Dark';
    theme.setAttribute('aria-label', `Switch to the ${name === 'dark' ? 'light' : 'dark'} theme`);
  });
  const toolbar = element('div', { class: 'toolbar' });
  const stages = element('div', { class: `stages stages-${page.swarms.length}` });
  const column = element('main', { class: 'column' }, toolbar, stages);
  const panels = element('aside', { class: 'panels', 'aria-label': 'Numbers' });
  const head = element(
    'header',
    { class: 'head' },
    element('span', { class: 'brand' }, 'beespace'),
    title,
    linkButton(copyLink),
    theme,
    button('?', { class: 'quiet-button', 'aria-label': 'Help', title: 'Help (?)' }, help),
  );
  const holder = document.getElementById('page') as HTMLElement;
  holder.append(head, column, panels);
  return { page: holder, toolbar, stages, column, panels };
}

function linkButton(copy: () => Promise<boolean>): HTMLElement {
  const said = element('span', { role: 'status', class: 'hidden-text' });
  const made = button('Copy link', { class: 'quiet-button', title: 'Copy a link to this moment, as it is seen' }, () => {
    void copy().then((copied) => {
      made.textContent = copied ? 'Copied' : 'See address';
      said.textContent = copied ? 'The link is copied.' : 'The link is in the address of this page.';
      setTimeout(() => (made.textContent = 'Copy link'), 2000);
    });
  });
  return element('span', {}, made, said);
}

export function toggleTheme(choices: Choices): void {
  choices.theme.set(choices.theme.value === 'dark' ? 'light' : 'dark');
}

/** What the page is at, until it is done. */
export function progress(text: string | null): Promise<void> {
  document.getElementById('stuck')?.remove();
  const line = document.getElementById('progress');
  if (line) {
    if (text === null) line.remove();
    else line.textContent = text;
  }
  // Lets the browser show it.
  return new Promise((resolve) => setTimeout(resolve, 0));
}

export function fail(text: string): void {
  for (const id of ['progress', 'stuck']) document.getElementById(id)?.remove();
  document.getElementById('page')?.append(element('p', { class: 'message', role: 'alert' }, text));
}
