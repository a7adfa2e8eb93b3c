// Numbers for readers.

/** Six significant digits at most, a true minus sign, `–` where there is no number. */
export function shown(value: number | null | undefined, digits = 6): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const plain = size === 0 || (size >= 1e-4 && size < 1e7);
  const text = plain ? String(Number(value.toPrecision(digits))) : value.toExponential(digits - 2);
  return text.replaceAll("-", "−");
}

export function withUnit(value: number, unit: string, digits = 6): string {
  return unit ? `${shown(value, digits)} ${unitShown(unit)}` : shown(value, digits);
}

/** `mm/s^2` as it is set in print. */
export function unitShown(unit: string): string {
  return unit.replaceAll("^2", "²").replaceAll("^3", "³").replaceAll("*", "·");
}

/** A signal with its unit. */
export function heading(name: string, unit: string): string {
  return unit ? `${name} [${unitShown(unit)}]` : name;
}
