// The row of a study that everything shows at the moment: drawing, curves, hodographs.

export class Cursor {
  private listeners: ((row: number, source: unknown) => void)[] = [];
  row = 0;

  constructor(readonly rows: number) {}

  /** Moves everything to `row`; `source` is told so that it need not follow itself. */
  set(row: number, source: unknown): void {
    const next = Math.max(0, Math.min(this.rows - 1, Math.round(row)));
    if (next === this.row) return;
    this.row = next;
    for (const listener of this.listeners) listener(next, source);
  }

  follow(listener: (row: number, source: unknown) => void): void {
    this.listeners.push(listener);
  }
}
