// A table of many rows, sorted by any column and shown a page at a time.
import { button, element } from '../text/element';
import { formatCount } from '../text/numbers';

export interface TableColumn {
  label: string;
  /** What the row at this place is sorted by. */
  rank: (place: number) => number;
  cell: (place: number) => Node | string;
  numeric?: boolean;
}

interface Sorting {
  column: number;
  descending: boolean;
}

const kPage = 50;

/** Places of all rows in the order wanted; equal ones stay as they were. */
export function sortedPlaces(count: number, rank: (place: number) => number, descending: boolean): Uint32Array {
  const ranks = Float64Array.from({ length: count }, (_, place) => rank(place));
  const places = Uint32Array.from({ length: count }, (_, place) => place);
  const sign = descending ? -1 : 1;
  return places.sort((a, b) => sign * (ranks[a] - ranks[b]) || a - b);
}

export class PagedTable {
  readonly box = element('div', { class: 'paged' });
  readonly #heads: HTMLTableCellElement[];
  readonly #body = element('tbody');
  readonly #range = element('span', { class: 'range', role: 'status' });
  readonly #scroll: HTMLElement;
  readonly #older: HTMLButtonElement;
  readonly #newer: HTMLButtonElement;
  #sorting: Sorting;
  #sorted: Uint32Array;
  #kept: Uint32Array;
  #keep: ((place: number) => boolean) | null = null;
  #page = 0;

  constructor(
    caption: string,
    readonly columns: TableColumn[],
    readonly count: number,
    /** What the list is sorted by as it comes. */
    given: Sorting,
    readonly choose: (place: number) => void,
    readonly isChosen: (place: number) => boolean,
  ) {
    this.#sorting = given;
    this.#sorted = Uint32Array.from({ length: count }, (_, place) => place);
    this.#kept = this.#sorted;
    this.#heads = columns.map((column, place) =>
      element(
        'th',
        { scope: 'col', class: column.numeric ? 'number' : '' },
        button(column.label, { class: 'sort' }, () => this.#sortBy(place)),
      ),
    );
    this.#scroll = element(
      'div',
      { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': caption },
      element(
        'table',
        {},
        element('caption', { class: 'hidden-text' }, caption),
        element('thead', {}, element('tr', {}, ...this.#heads)),
        this.#body,
      ),
    );
    this.#older = button('‹', { 'aria-label': 'Previous page of the table' }, () => this.#turn(-1));
    this.#newer = button('›', { 'aria-label': 'Next page of the table' }, () => this.#turn(1));
    this.box.append(this.#scroll, element('div', { class: 'pager' }, this.#older, this.#range, this.#newer));
    this.#fill();
  }

  /** Places of the rows that are kept, in their order. */
  get places(): Uint32Array {
    return this.#kept;
  }

  filter(keep: ((place: number) => boolean) | null): void {
    this.#keep = keep;
    this.#page = 0;
    this.#keepSome();
    this.#fill();
  }

  /** Marks the chosen row anew. */
  refresh(): void {
    for (const row of this.#body.rows) {
      const place = Number(row.dataset.place);
      if (this.isChosen(place)) row.setAttribute('aria-current', 'true');
      else row.removeAttribute('aria-current');
    }
  }

  #sortBy(column: number): void {
    const descending = this.#sorting.column === column ? !this.#sorting.descending : false;
    this.#sorting = { column, descending };
    this.#sorted = sortedPlaces(this.count, this.columns[column].rank, descending);
    this.#page = 0;
    this.#keepSome();
    this.#fill();
  }

  #keepSome(): void {
    this.#kept = this.#keep ? this.#sorted.filter(this.#keep) : this.#sorted;
  }

  #turn(pages: number): void {
    this.#page += pages;
    this.#fill();
    this.#scroll.scrollTop = 0;
  }

  #fill(): void {
    this.#heads.forEach((head, column) => {
      const sorted = this.#sorting.column === column;
      if (sorted) head.setAttribute('aria-sort', this.#sorting.descending ? 'descending' : 'ascending');
      else head.removeAttribute('aria-sort');
    });
    const begin = this.#page * kPage;
    const end = Math.min(begin + kPage, this.#kept.length);
    this.#body.replaceChildren(...Array.from(this.#kept.subarray(begin, end), (place) => this.#row(place)));
    this.#range.textContent =
      this.#kept.length === 0
        ? 'None'
        : `${formatCount(begin + 1)}–${formatCount(end)} of ${formatCount(this.#kept.length)}`;
    this.#older.disabled = begin === 0;
    this.#newer.disabled = end === this.#kept.length;
    this.refresh();
  }

  #row(place: number): HTMLTableRowElement {
    const cells = this.columns.map((column, i) => {
      const content = column.cell(place);
      if (i > 0) return element('td', { class: column.numeric ? 'number' : '' }, content);
      // The first cell holds the button for the keyboard; the whole row serves the mouse.
      const show = element('button', { type: 'button', class: 'link' }, content);
      return element('td', { class: column.numeric ? 'number' : '' }, show);
    });
    const row = element('tr', { 'data-place': String(place) }, ...cells);
    row.addEventListener('click', () => this.choose(place));
    return row;
  }
}
