// Elements in one line. Text always goes in as text: names come from files.

type Props = Record<string, string | number | boolean | ((event: Event) => void)>;

export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  props: Props = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (typeof value === "boolean") element.toggleAttribute(name, value);
    else element.setAttribute(name, String(value));
  }
  element.append(...children);
  return element;
}

export function choice(label: string, options: [string, string][], change: (value: string) => void): HTMLSelectElement {
  const select = make(
    "select",
    { "aria-label": label, title: label },
    ...options.map(([value, text]) => make("option", { value }, text)),
  );
  select.addEventListener("change", () => change(select.value));
  return select;
}

export function toggle(label: string, checked: boolean, change: (on: boolean) => void): HTMLLabelElement {
  const box = make("input", { type: "checkbox" });
  box.checked = checked;
  box.addEventListener("change", () => change(box.checked));
  return make("label", { class: "toggle" }, box, label);
}
