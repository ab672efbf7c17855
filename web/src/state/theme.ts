// Dark or light: as the system has it, until the reader chooses.
import { Signal } from './signal';

export type Theme = 'dark' | 'light';

export function followTheme(): Signal<Theme> {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const theme = new Signal<Theme>(dark.matches ? 'dark' : 'light');
  dark.addEventListener('change', () => theme.set(dark.matches ? 'dark' : 'light'));
  theme.watch((name) => {
    document.documentElement.dataset.theme = name;
  });
  return theme;
}
