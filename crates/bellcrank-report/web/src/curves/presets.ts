// The charts a reader starts with.

import { signal, type Signal, type Study } from "../data";

export interface Preset {
  title: string;
  names: string[];
}

const MOST = 8;

export function presets(study: Study): Preset[] {
  const driven = study.signals.flatMap(({ name }) => /^drive\.(.+?)\.force(\.\d+)?$/.exec(name)?.[1] ?? []);
  const motion = (quantity: string) => shortlist(study, jointSignals(study, quantity), driven);
  const named = (pattern: RegExp) => study.signals.filter(({ name }) => pattern.test(name));
  const all: [string, Signal[]][] = [
    ["Drive effort", named(/^drive\..+\.force(\.\d+)?$/)],
    ["Joint position", motion("position")],
    ["Joint velocity", motion("velocity")],
    ["Joint acceleration", motion("acceleration")],
    ["Drive power", named(/^drive\..+\.power(\.\d+)?$/)],
    ["Reaction, force magnitude", strongest(named(/^joint\..+\.reaction\.force$/))],
  ];
  const found = all
    .filter(([, signals]) => signals.length > 0)
    .map(([title, signals]) => ({ title, names: signals.slice(0, MOST).map(({ name }) => name) }));
  return found.length > 0 ? found : [{ title: "Signals", names: study.signals.slice(0, 4).map(({ name }) => name) }];
}

function jointSignals(study: Study, quantity: string): Signal[] {
  const pattern = new RegExp(`^joint\\..+\\.${quantity}(\\.\\d+)?$`);
  return study.signals.filter(({ name }) => pattern.test(name));
}

/** Driven joints where there are any, else all; never the axis over itself. */
function shortlist(study: Study, signals: Signal[], driven: string[]): Signal[] {
  const others = signals.filter(({ name }) => !study.axis.includes(name));
  const moved = others.filter(({ name }) => driven.some((joint) => name.startsWith(`joint.${joint}.`)));
  const swept = study.axis.flatMap((name) => name.replace(/\.position(\.\d+)?$/, ""));
  const near = others.filter(({ name }) => swept.some((joint) => name.startsWith(`${joint}.`)));
  const list = [...moved, ...near.filter((one) => !moved.includes(one))];
  return list.length > 0 ? list : others.length > 0 ? others : signals;
}

function strongest(signals: Signal[]): Signal[] {
  const peak = ({ values }: Signal) => Array.from(values).reduce((most, v) => (v > most ? v : most), 0);
  return [...signals].sort((a, b) => peak(b) - peak(a));
}

/** Signals that can carry the horizontal axis: those that only rise or only fall. */
export function axes(study: Study): Signal[] {
  const first = study.axis.flatMap((name) => signal(study, name) ?? []);
  const clock = study.signals.filter(({ name }) => name === "time");
  const positions = jointSignals(study, "position");
  const candidates = [...new Set([...first, ...clock, ...positions])];
  return candidates.filter((candidate) => direction(candidate.values) !== 0);
}

/** 1 where values rise all the way, −1 where they fall, else 0. */
export function direction(values: ArrayLike<number>): number {
  const sign = Math.sign(values[values.length - 1] - values[0]);
  for (let i = 1; i < values.length; i++) if (!((values[i] - values[i - 1]) * sign > 0)) return 0;
  return sign || 0;
}
