// What the page undoes at once may be several steps of the library: a click and the numbers that followed it.
// SPDX-License-Identifier: Apache-2.0
import type { Segmentation } from 'toothseg-wasm';

export class Steps {
  private done: number[] = [];
  private undone: number[] = [];

  constructor(private readonly segmentation: Segmentation) {
    // Of a session that was read: its steps as they are written, each with the numbering that follows it.
    const { steps = [], undone = 0 } = JSON.parse(segmentation.writeSession()) as { steps?: { act?: string }[]; undone?: number };
    const names = steps.map((step) => step.act);
    for (const [list, to] of [[names.slice(0, names.length - undone), this.done], [names.slice(names.length - undone), this.undone]] as const)
      for (const name of list)
        if (name !== 'assign_numbers') to.push(1);
        else if (to.length > 0) ++to[to.length - 1]; // before any other step they are those of opening, and stay
    this.undone.reverse();
  }

  /** Runs what makes steps; they count as one from now on. */
  run<T>(work: () => T): T {
    const before = this.segmentation.history().undo;
    try {
      return work();
    } finally {
      const made = this.segmentation.history().undo - before;
      if (made > 0) {
        this.done.push(made);
        this.undone = [];
      }
    }
  }

  get canUndo(): number {
    return this.done.length;
  }

  get canRedo(): number {
    return this.undone.length;
  }

  /** Gives the teeth that changed. */
  undo(): number[] {
    return this.go(this.done, this.undone, () => this.segmentation.undo());
  }

  redo(): number[] {
    return this.go(this.undone, this.done, () => this.segmentation.redo());
  }

  private go(from: number[], to: number[], step: () => void): number[] {
    const changed = new Set<number>();
    const count = from.pop();
    if (count === undefined) throw new Error('There is nothing more to take back or bring again.');
    for (let i = 0; i < count; ++i) {
      step();
      this.segmentation.changes().forEach((id) => changed.add(id));
    }
    to.push(count);
    return [...changed];
  }
}
