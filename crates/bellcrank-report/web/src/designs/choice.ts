// Which designs pass: those inside every stretch that the reader has drawn on an axis.

import type { Designs } from "../data";

export type Stretch = [number, number];

export class Selection {
  readonly passes: Uint8Array;
  readonly stretches = new Map<number, Stretch>();
  count = 0;
  private readonly followers: (() => void)[] = [];

  constructor(private readonly designs: Designs) {
    this.passes = new Uint8Array(designs.rows);
    this.update();
  }

  follow(act: () => void): void {
    this.followers.push(act);
  }

  set(column: number, stretch: Stretch | null): void {
    if (stretch) this.stretches.set(column, stretch);
    else this.stretches.delete(column);
    this.update();
    for (const act of this.followers) act();
  }

  clear(): void {
    this.stretches.clear();
    this.update();
    for (const act of this.followers) act();
  }

  private update(): void {
    const stretches = [...this.stretches].map(([column, [low, high]]) => ({ values: this.designs.columns[column].values, low, high }));
    this.count = 0;
    for (let row = 0; row < this.passes.length; row++) {
      const inside = stretches.every(({ values, low, high }) => values[row] >= low && values[row] <= high);
      this.passes[row] = inside ? 1 : 0;
      this.count += inside ? 1 : 0;
    }
  }
}
