// What stands below the picture: exposure and samples, the clip box, of volumes the values that are shown, and the picked voxel.
import type { Model } from "./model.js";

const AXES = ["x", "y", "z"] as const;

export class Panel {
  readonly element = document.createElement("details");
  readonly #picked = document.createElement("div");
  readonly #heard: { name: string; heard: () => void }[] = [];
  /** Brings each row to what the model says. */
  #updates: (() => void)[] = [];
  #presets = "";

  constructor(
    private readonly model: Model,
    line: HTMLElement,
  ) {
    this.element.className = "voxtrace-panel";
    this.#picked.className = "voxtrace-picked";
    this.#picked.setAttribute("role", "status");
    line.append(this.#picked);
    for (const name of ["picked", "problem"]) this.#on(`change:${name}`, () => this.#tell());
    for (const name of ["_about", "exposure", "samples", "clip", "threshold", "preset"]) this.#on(`change:${name}`, () => this.#update());
    this.#build();
    this.#tell();
  }

  end() {
    for (const { name, heard } of this.#heard) this.model.off(name, heard);
  }

  #on(name: string, heard: () => void) {
    this.model.on(name, heard);
    this.#heard.push({ name, heard });
  }

  #save<N extends "exposure" | "samples" | "clip" | "threshold" | "preset">(name: N, value: ReturnType<typeof this.model.get<N>>) {
    this.model.set(name, value);
    this.model.save_changes();
  }

  #build() {
    const { values, bounds } = this.model.get("_about");
    this.#presets = values?.presets.join() ?? "";
    this.#updates = [];
    const summary = document.createElement("summary");
    summary.textContent = "Light, samples, clip box" + (values ? ", values" : "");
    const clip = bounds ? AXES.map((_, index) => this.#clip(index)) : [];
    this.element.replaceChildren(summary, this.#exposure(), this.#samples(), ...clip, ...(values ? [this.#preset(values.presets), this.#threshold()] : []));
    this.#update();
  }

  /** Rows stay where they are, so that who holds one goes on; of other kinds of scenes there are others. */
  #update() {
    if ((this.model.get("_about").values?.presets.join() ?? "") !== this.#presets) this.#build();
    else for (const update of this.#updates) update();
  }

  #exposure() {
    const [slider, shown] = [range("Exposure"), text("")];
    Object.assign(slider, { min: "-6", max: "6", step: "0.1" });
    slider.addEventListener("input", () => this.#save("exposure", slider.valueAsNumber));
    this.#updates.push(() => {
      slider.value = String(this.model.get("exposure"));
      shown.textContent = `${this.model.get("exposure").toFixed(1)} stops`;
    });
    return row("Exposure", slider, shown);
  }

  #samples() {
    const input = document.createElement("input");
    Object.assign(input, { type: "number", min: "1", max: "65536", step: "1" });
    input.addEventListener("change", () => {
      if (input.valueAsNumber >= 1) this.#save("samples", Math.min(65_536, Math.round(input.valueAsNumber)));
    });
    this.#updates.push(() => (input.value = String(this.model.get("samples"))));
    return row("Samples", input);
  }

  /** The lowest and the highest place of an axis that is shown. */
  #clip(axis: number) {
    const ends = ["lowest", "highest"].map((side) => range(`Clip box, ${side} ${AXES[axis]}`)) as [HTMLInputElement, HTMLInputElement];
    const shown = text("");
    this.#updates.push(() => {
      const bounds = this.model.get("_about").bounds;
      if (!bounds) return;
      const [least, most] = [Math.floor(bounds[0][axis]!), Math.ceil(bounds[1][axis]!)];
      const clip = this.model.get("clip") ?? bounds;
      ends.forEach((end, side) => {
        Object.assign(end, { min: String(least), max: String(most), step: String(Math.min(1, (most - least) / 200)) });
        end.value = String(clip[side]![axis]);
      });
      shown.textContent = ends.map((end) => short(end.valueAsNumber)).join(" – ");
    });
    ends.forEach((end, side) => end.addEventListener("input", () => {
      // An empty box shows nothing, and is refused.
      const other = ends[1 - side]!.valueAsNumber;
      if (ends[0].valueAsNumber >= ends[1].valueAsNumber) end.value = String(other + (side === 0 ? -1 : 1) * Number(end.step));
      const [low, high] = ends.map((end) => end.valueAsNumber);
      const bounds = this.model.get("_about").bounds;
      if (bounds && low! < high!) this.#save("clip", clipWith(this.model.get("clip") ?? bounds, bounds, axis, low!, high!));
    }));
    return row(`Clip ${AXES[axis]}`, ...ends, shown);
  }

  #preset(presets: string[]) {
    const select = document.createElement("select");
    for (const name of presets) select.append(new Option(name || "automatic", name));
    select.addEventListener("change", () => this.#save("preset", select.value));
    this.#updates.push(() => (select.value = this.model.get("preset")));
    return row("Colours", select);
  }

  /** From which value on something is shown, over how often values occur. */
  #threshold() {
    const [slider, shown, over] = [range("Shown from this value on"), text(""), document.createElement("div")];
    over.className = "voxtrace-histogram";
    this.#updates.push(() => {
      const { values } = this.model.get("_about");
      if (!values) return;
      Object.assign(slider, { min: String(values.low), max: String(values.high), step: String((values.high - values.low) / 500) });
      const threshold = this.model.get("threshold") ?? values.threshold;
      slider.value = String(threshold);
      // The slider has steps, the threshold none.
      shown.textContent = short(threshold);
      if (over.childElementCount === 0) over.append(histogram(values.counts), slider);
    });
    slider.addEventListener("input", () => (shown.textContent = short(slider.valueAsNumber)));
    // Voxels are made anew in the kernel: when the slider is let go.
    slider.addEventListener("change", () => this.#save("threshold", slider.valueAsNumber));
    return row("Shown from", over, shown);
  }

  #tell() {
    const picked = this.model.get("picked") as { voxel: number[]; name?: string; color: string; material: number; value?: number } | null;
    this.#picked.textContent = this.model.get("problem");
    if (!picked || this.model.get("problem")) return;
    const swatch = document.createElement("span");
    swatch.className = "voxtrace-swatch";
    swatch.style.background = picked.color;
    const value = picked.value === undefined ? "" : `, value ${short(picked.value)}`;
    this.#picked.append(swatch, `voxel ${picked.voxel.join(", ")}${picked.name ? ` of ${picked.name}` : ""}, material ${picked.material}${value}`);
  }
}

/** A box with other ends along an axis; none where it is all of the scene. */
function clipWith(clip: [number[], number[]], bounds: [number[], number[]], axis: number, low: number, high: number): [number[], number[]] | null {
  const changed = clip.map((corner) => [...corner]) as [number[], number[]];
  [changed[0][axis], changed[1][axis]] = [low, high];
  const isWhole = [0, 1, 2].every((at) => changed[0][at]! <= bounds[0][at]! && changed[1][at]! >= bounds[1][at]!);
  return isWhole ? null : changed;
}

/** A number with four digits. */
const short = (value: number) => String(Number(value.toPrecision(4)));

function text(content: string) {
  const span = document.createElement("span");
  span.textContent = content;
  return span;
}

function row(name: string, ...content: HTMLElement[]) {
  const label = document.createElement("label");
  label.append(text(name), ...content);
  return label;
}

function range(label: string) {
  const input = document.createElement("input");
  input.type = "range";
  input.setAttribute("aria-label", label);
  return input;
}

/** How often values occur, on a logarithmic scale. */
function histogram(counts: number[]) {
  const most = Math.log1p(Math.max(1, ...counts));
  const bars = counts.map((count, index) => `M${index},100V${(100 - (100 * Math.log1p(count)) / most).toFixed(1)}h1V100`).join("");
  const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  svg.setAttribute("viewBox", `0 0 ${counts.length || 1} 100`);
  svg.setAttribute("preserveAspectRatio", "none");
  const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
  path.setAttribute("d", bars);
  svg.append(path);
  return svg;
}
