// A line swept into a ribbon, on a 2-D canvas. Nothing moves unless it is moved by hand.
for (const box of document.querySelectorAll(".view")) {
  const canvas = box.querySelector("canvas"), slider = box.querySelector("input"), shown = box.querySelector("output")
  const packed = JSON.parse(box.querySelector("script").textContent)
  const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer
  const P = new Float32Array(bytes(packed.points)), U = new Float32Array(bytes(packed.displacement))
  const V = new Float32Array(bytes(packed.shares)), half = packed.width / 2, n = P.length / 2
  const Q = new (packed.wide ? Uint32Array : Uint16Array)(bytes(packed.cells))
  const stops = packed.ramp.map(s => [1, 3, 5].map(k => parseInt(s.slice(k, k + 2), 16)))
  const reach = k => { let a = Infinity, b = -Infinity; for (let i = k; i < P.length; i += 2) { a = Math.min(a, P[i]); b = Math.max(b, P[i]) } return [(a + b) / 2, (b - a) / 2] }
  const [[mx, rx], [my, ry]] = [reach(0), reach(1)], radius = Math.hypot(rx, ry, half)
  const start = { yaw: 0.62, pitch: 0.45, zoom: 1.05 }
  let view = { ...start }, waiting = false
  Object.assign(canvas.style, { display: "block", width: "100%", aspectRatio: "16 / 9", touchAction: "pan-y", cursor: "grab" })

  const colour = (share, shade) => {
    const t = share * (stops.length - 1), i = Math.max(0, Math.min(Math.floor(t), stops.length - 2)), f = t - i
    const to = stops[Math.min(i + 1, stops.length - 1)]
    return `rgb(${stops[i].map((c, k) => Math.round((c + (to[k] - c) * f) * shade)).join()})`
  }

  function draw() {
    waiting = false
    const ratio = Math.max(devicePixelRatio || 1, 2), w = canvas.clientWidth, h = canvas.clientHeight
    if (!w || !h) return // not laid out: a closed <details>
    canvas.width = w * ratio; canvas.height = h * ratio
    const g = canvas.getContext("2d"), by = Number(slider.value)
    g.scale(ratio, ratio); g.lineJoin = "round"
    const [cy, sy, cp, sp] = [Math.cos(view.yaw), Math.sin(view.yaw), Math.cos(view.pitch), Math.sin(view.pitch)]
    const k = view.zoom * 0.47 * Math.min(w, 1.5 * h) / radius
    // the sweep along z is one step for every point: half of it to either side
    const zx = k * sy * half, zy = k * sp * cy * half
    const project = scale => {
      const S = new Float32Array(3 * n)
      for (let i = 0; i < n; i++) {
        const x = P[2 * i] + scale * U[2 * i] - mx, y = P[2 * i + 1] + scale * U[2 * i + 1] - my
        S[3 * i] = w / 2 + k * cy * x; S[3 * i + 1] = h / 2 - k * (cp * y + sp * sy * x); S[3 * i + 2] = k * (sp * y - cp * sy * x)
      }
      return S
    }
    const R = project(0), S = project(by)
    g.strokeStyle = getComputedStyle(canvas).color; g.globalAlpha = 0.4; g.lineWidth = 1; g.setLineDash([4, 3]); g.beginPath()
    for (const side of [-1, 1]) for (let c = 0; c < Q.length; c += 2) {
      const a = 3 * Q[c], b = 3 * Q[c + 1]
      if (c === 0 || Q[c] !== Q[c - 1]) g.moveTo(R[a] + side * zx, R[a + 1] + side * zy)
      g.lineTo(R[b] + side * zx, R[b + 1] + side * zy)
    }
    if (by) g.stroke()
    g.globalAlpha = 1; g.setLineDash([]); g.lineWidth = 0.8
    // far ones first: exact for strips that share one direction
    const order = Array.from(V, (_, c) => c).sort((a, b) => S[3 * Q[2 * a] + 2] + S[3 * Q[2 * a + 1] + 2] - S[3 * Q[2 * b] + 2] - S[3 * Q[2 * b + 1] + 2])
    const zl = Math.hypot(zx, zy) || 1
    for (const c of order) {
      const a = 3 * Q[2 * c], b = 3 * Q[2 * c + 1], ex = S[b] - S[a], ey = S[b + 1] - S[a + 1]
      const el = Math.hypot(ex, ey, S[b + 2] - S[a + 2]) || 1, turned = Math.abs(ex * zy - ey * zx) / (el * k * half)
      g.fillStyle = g.strokeStyle = colour(V[c], zl < 1 ? 1 : 0.74 + 0.26 * turned)
      g.beginPath(); g.moveTo(S[a] - zx, S[a + 1] - zy); g.lineTo(S[b] - zx, S[b + 1] - zy)
      g.lineTo(S[b] + zx, S[b + 1] + zy); g.lineTo(S[a] + zx, S[a + 1] + zy); g.closePath(); g.fill(); g.stroke()
    }
  }

  const redraw = () => { if (!waiting) { waiting = true; requestAnimationFrame(draw) } }
  const turn = (dx, dy) => { view.yaw += dx; view.pitch = Math.max(-1.5, Math.min(1.5, view.pitch + dy)); redraw() }
  const zoom = by => { view.zoom = Math.max(0.3, Math.min(30, view.zoom * by)); redraw() }
  const fingers = new Map()
  const spread = () => { const [a, b] = fingers.values(); return Math.hypot(a.x - b.x, a.y - b.y) || 1 }
  canvas.addEventListener("pointerdown", e => { canvas.setPointerCapture(e.pointerId); canvas.focus({ preventScroll: true }); fingers.set(e.pointerId, { x: e.clientX, y: e.clientY }) })
  canvas.addEventListener("pointermove", e => {
    const last = fingers.get(e.pointerId)
    if (!last) return
    const before = fingers.size === 2 && spread(), dx = e.clientX - last.x, dy = e.clientY - last.y
    last.x = e.clientX; last.y = e.clientY
    if (before) zoom(spread() / before)
    else turn(dx / 120, dy / 120)
  })
  for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, e => fingers.delete(e.pointerId))
  // the wheel scrolls the page until the view is picked
  canvas.addEventListener("wheel", e => { if (e.ctrlKey || document.activeElement === canvas) { e.preventDefault(); zoom(Math.exp(-e.deltaY / 400)) } }, { passive: false })
  canvas.addEventListener("keydown", e => {
    if (e.ctrlKey || e.metaKey || e.altKey) return
    const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[e.key]
    if (step) turn(...step)
    else if (e.key === "+" || e.key === "=") zoom(1.15)
    else if (e.key === "-") zoom(1 / 1.15)
    else if (e.key === "r" || e.key === "R") { view = { ...start }; slider.value = slider.defaultValue; tell() }
    else return
    e.preventDefault()
  })
  const tell = () => { shown.textContent = `× ${Number(slider.value)}`; redraw() }
  slider.addEventListener("input", tell)
  for (const query of ["(prefers-color-scheme: dark)", "print"]) matchMedia(query).addEventListener("change", draw)
  new ResizeObserver(redraw).observe(canvas)
}
