// A value, and the callbacks for its changes.

export class Signal<T> {
  #value: T;
  readonly #listeners = new Set<(value: T) => void>();

  constructor(value: T) {
    this.#value = value;
  }

  get value(): T {
    return this.#value;
  }

  set(value: T): void {
    if (Object.is(value, this.#value)) return;
    this.#value = value;
    for (const listener of this.#listeners) listener(value);
  }

  /** Calls whenever the value changes. */
  listen(listener: (value: T) => void): void {
    this.#listeners.add(listener);
  }

  /** Calls at once, and then whenever the value changes. */
  watch(listener: (value: T) => void): void {
    this.listen(listener);
    listener(this.#value);
  }
}
