// Dark or light: as the system has it; what the reader chose against it holds until the two agree again.
import { Signal } from './signal';

export type Theme = 'dark' | 'light';

export function followTheme(): Signal<Theme> {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  let system: Theme = dark.matches ? 'dark' : 'light';
  const theme = new Signal<Theme>(system);
  dark.addEventListener('change', () => {
    const chosen = theme.value !== system;
    system = dark.matches ? 'dark' : 'light';
    if (!chosen) theme.set(system);
  });
  theme.watch((name) => {
    document.documentElement.dataset.theme = name;
  });
  return theme;
}
