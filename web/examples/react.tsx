// A page of React with the element: `import "voxtrace"` defines it, `voxtrace/react` gives it its types.
import { useRef, useState } from "react";
import { createRoot } from "react-dom/client";
import type { VoxtraceViewer } from "voxtrace";
import "voxtrace";
import type {} from "voxtrace/react";

function App() {
  const viewer = useRef<VoxtraceViewer>(null);
  const [exposure, setExposure] = useState(0);
  const [text, setText] = useState("It is being traced.");
  return (
    <main>
      <h1>voxtrace in React</h1>
      <voxtrace-viewer
        ref={viewer}
        src="scene:city?voxels=50k"
        alt="A small city"
        samples={4}
        exposure={exposure}
        camera-controls
        style={{ width: "320px", height: "180px" }}
        onstill={() => setText("The picture is finished.")}
      />
      <p>{text}</p>
      <label>
        Exposure <input type="range" min={-4} max={4} value={exposure} onChange={(event) => setExposure(Number(event.target.value))} />
      </label>
    </main>
  );
}

createRoot(document.body.appendChild(document.createElement("div"))).render(<App />);
