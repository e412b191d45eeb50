// Modes of turning shafts: every point runs along its orbit, all at one phase.
for (const drawing of document.querySelectorAll("svg.whirl")) {
  const rows = text => text.split(" ").map(row => row.split(",").map(Number))
  const parts = [...drawing.querySelectorAll("[data-line],[data-dots]")].map(path => [path, "dots" in path.dataset, rows(path.dataset.dots ?? path.dataset.line)])
  const still = matchMedia("(prefers-reduced-motion: reduce)"), button = document.createElement("button"), line = document.createElement("p")
  const period = 2600 // ms
  let phase = 0, before = 0, going = !still.matches, seen = false, frame = 0
  button.type = "button"; line.className = "controls"; line.append(button); drawing.after(line)
  function draw(now) {
    frame = 0
    phase = (phase + Math.min(now - before, 100) / period) % 1; before = now
    const c = Math.cos(2 * Math.PI * phase), s = Math.sin(2 * Math.PI * phase)
    for (const [path, dots, points] of parts) {
      const at = points.map(([x, y, a, b, e, f]) => `${(x + a * c + e * s).toFixed(1)},${(y + b * c + f * s).toFixed(1)}`)
      path.setAttribute("d", dots ? at.map(p => `M${p}h0`).join("") : `M${at.join("L")}`)
    }
    run()
  }
  function run() {
    button.textContent = going ? "Pause" : "Play"
    if (going && seen && !frame) frame = requestAnimationFrame(draw)
  }
  button.addEventListener("click", () => { going = !going; before = performance.now(); run() })
  still.addEventListener("change", () => { going = !still.matches; run() })
  new IntersectionObserver(found => { seen = found.at(-1).isIntersecting; before = performance.now(); run() }).observe(drawing)
  run()
}
