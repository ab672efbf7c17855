// What keys do anywhere on the page; panels/help.ts tells them.

export interface KeyActions {
  search: () => void;
  pair: (place: number) => void;
  nextPair: (direction: 1 | -1) => void;
  turn: (aside: number, up: number) => void;
  shift: (right: number, up: number) => void;
  zoom: (factor: number) => void;
  home: () => void;
  fromAbove: () => void;
  fromSide: () => void;
  flyToSelected: () => void;
  toggleAtRiskOnly: () => void;
  toggleGroup: () => void;
  toggleTheme: () => void;
  measure: () => void;
  nextColours: () => void;
  clear: () => void;
  help: () => void;
  /** Only where time goes on. */
  time: {
    toggle: () => void;
    step: (steps: number) => void;
    conflict: (direction: 1 | -1) => void;
    speed: (places: number) => void;
    begin: () => void;
    end: () => void;
    trails: () => void;
    vectors: () => void;
  } | null;
}

const kTurn = Math.PI / 36;
const kShift = 0.06;
const kZoom = 1.25;

function actionOf(event: KeyboardEvent, act: KeyActions): (() => void) | undefined {
  const { key, shiftKey, target } = event;
  const arrows: Record<string, [number, number]> = {
    ArrowLeft: [-1, 0],
    ArrowRight: [1, 0],
    ArrowUp: [0, 1],
    ArrowDown: [0, -1],
  };
  const arrow = arrows[key];
  if (arrow) {
    // Elsewhere arrows scroll.
    if (!(target instanceof HTMLCanvasElement) && target !== document.body) return undefined;
    const [right, up] = arrow;
    return shiftKey ? () => act.shift(kShift * right, kShift * up) : () => act.turn(kTurn * right, kTurn * up);
  }
  if (/^[1-9]$/.test(key)) return () => act.pair(Number(key) - 1);
  const { time } = act;
  const simple: Record<string, (() => void) | undefined> = {
    '/': act.search,
    n: () => act.nextPair(1),
    p: () => act.nextPair(-1),
    '+': () => act.zoom(kZoom),
    '=': () => act.zoom(kZoom),
    '-': () => act.zoom(1 / kZoom),
    r: act.home,
    t: act.fromAbove,
    s: act.fromSide,
    f: act.flyToSelected,
    o: act.toggleAtRiskOnly,
    g: act.toggleGroup,
    d: act.toggleTheme,
    m: act.measure,
    c: act.nextColours,
    Escape: act.clear,
    '?': act.help,
    ...(time && {
      ' ': time.toggle,
      ',': () => time.step(-1),
      '.': () => time.step(1),
      '[': () => time.conflict(-1),
      ']': () => time.conflict(1),
      '<': () => time.speed(-1),
      '>': () => time.speed(1),
      Home: time.begin,
      End: time.end,
      l: time.trails,
      v: time.vectors,
    }),
  };
  return simple[key.length === 1 ? key.toLowerCase() : key];
}

/** Whether who moves the focus does it by the keyboard: then the space bar is for what has it. */
function followFocus(): () => boolean {
  let byKeyboard = false;
  addEventListener('keydown', ({ key }) => (byKeyboard ||= key === 'Tab'), { capture: true });
  addEventListener('pointerdown', () => (byKeyboard = false), { capture: true });
  return () => byKeyboard;
}

export function listenToKeys(act: KeyActions): void {
  const byKeyboard = followFocus();
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    if (document.querySelector('dialog[open]')) return;
    const { target } = event;
    if (!(target instanceof Element)) return;
    if (target.matches('input[type="search"], textarea') || (target.matches('select') && (event.key !== ' ' || byKeyboard()))) return;
    // Buttons and boxes that were reached by the keyboard have the space bar for themselves, and regions that scroll their ends.
    if (event.key === ' ' && target.matches('button, input, summary')) {
      if (byKeyboard() || !act.time) return;
      (target as HTMLElement).blur();
    }
    if ((event.key === 'Home' || event.key === 'End') && target.closest('.scroll')) return;
    const action = actionOf(event, act);
    if (!action) return;
    event.preventDefault();
    action();
  });
}
