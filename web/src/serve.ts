// The worker's end of calls: one at a time.
import type { Answer, Calls, Request } from "./protocol.js";

/** Buffers that go over to the page instead of being copied. */
function buffersOf(made: unknown): Transferable[] {
  const values = made && typeof made === "object" && !ArrayBuffer.isView(made) ? Object.values(made) : [made];
  return values.filter((value) => ArrayBuffer.isView(value)).map((view) => view.buffer as ArrayBuffer);
}

/** Answers the page's calls by these functions. */
export function serveCalls(calls: Partial<Calls>) {
  addEventListener("message", ({ data }: MessageEvent<Request>) => {
    let answer: Answer;
    try {
      const call = calls[data.name] as ((...given: unknown[]) => unknown) | undefined;
      if (!call) throw new Error(`this module has no ${data.name}`);
      answer = { id: data.id, made: call(...data.given) };
    } catch (error) {
      // After a trap, or a panic of ours, the module's memory is not to be trusted.
      const isTrap = error instanceof WebAssembly.RuntimeError;
      const text = error instanceof Error ? error.message : String(error);
      const isFatal = isTrap || text.startsWith("panicked");
      answer = { id: data.id, error: isTrap ? `the tracer stopped, most likely for want of memory (${text})` : text, isFatal };
    }
    postMessage(answer, { transfer: "made" in answer ? buffersOf(answer.made) : [] });
  });
}
