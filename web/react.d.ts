// Types of <voxtrace-viewer> for React 19 and later: `import type {} from "voxtrace/react"`.
import type { DetailedHTMLProps, HTMLAttributes } from "react";
import type { Picked, VoxtraceViewer } from "./dist/index.js";

interface ViewerAttributes extends HTMLAttributes<VoxtraceViewer> {
  src?: string;
  alt?: string;
  poster?: string;
  loading?: "auto" | "lazy" | "eager";
  reveal?: "auto" | "interaction" | "manual";
  "camera-controls"?: boolean;
  "camera-orbit"?: string;
  "camera-target"?: string;
  "field-of-view"?: string;
  "clip-box"?: string;
  "auto-rotate"?: boolean;
  exposure?: number;
  "tone-mapping"?: "agx" | "neutral" | "reinhard" | "linear";
  samples?: number;
  seed?: number;
  "max-bounces"?: number;
  "max-pixels"?: number;
  "real-time"?: "auto" | "off";
  "max-memory"?: number;
  tracer?: "auto" | "gpu" | "cpu";
  threads?: number;
  "no-drop"?: boolean;
  onload?: (event: CustomEvent) => void;
  onprogress?: (event: CustomEvent<{ totalProgress: number | undefined }>) => void;
  onerror?: (event: CustomEvent<{ type: string; message: string; sourceError: unknown }>) => void;
  "oncamera-change"?: (event: CustomEvent<{ source: "none" | "user-interaction"; orbit: string }>) => void;
  "ondetail-change"?: (event: CustomEvent<{ finest: number; coarsest: number; isExact: boolean }>) => void;
  "onvoxel-pick"?: (event: CustomEvent<Picked | null>) => void;
  onstill?: (event: CustomEvent<{ samples: number; width: number; height: number; isExact: boolean }>) => void;
}

declare module "react" {
  namespace JSX {
    interface IntrinsicElements {
      "voxtrace-viewer": DetailedHTMLProps<ViewerAttributes, VoxtraceViewer>;
    }
  }
}
