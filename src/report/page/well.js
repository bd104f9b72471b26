// The well of the load cases that are shown, below their curves: the hole across at the depth that is pointed at, the well in three
// dimensions, the assembly in its hole. Part of page.js, which makes a block `b` with curves and calls it.
'use strict'
function well_figures(b) {
   const {root, state, shown, look_of, name_of} = b, view = {}
   function draw_section() {                                    // the hole at the depth, seen down the hole, high side up
      const svg = view.section, p0 = shown()[0]
      svg.replaceChildren()
      if (!p0) return
      const hole = value_at(p0, 'hole', state.depth), s = 88 / hole
      make(svg, 'circle', {cx: 100, cy: 100, r: 88, class: 'wall'})
      make(svg, 'text', {x: 100, y: 9, 'text-anchor': 'middle'}, 'high side')
      for (const p of shown()) {
         const r = value_at(p, 'displacement', state.depth) * 2 * s, a = value_at(p, 'clock', state.depth) * Math.PI / 180
         make(svg, 'circle', {cx: 100 + r * Math.sin(a), cy: 100 - r * Math.cos(a), r: value_at(p, 'od', state.depth) * s, fill: 'none', 'stroke-width': 2, ...look_of(p)})
      }
   }

   function draw_3d() {
      const svg = view.well, p = shown()[0]
      svg.replaceChildren()
      if (!p) return
      const end = D.cases[p.case].depth, n = 400, q = column(state.tint).quantity, points = []
      for (let i = 0; i <= n; i++) points.push(['east', 'north', 'tvd'].map(a => value_at(p, a, i / n * end)))
      const ends = [0, 1, 2].map(k => [Math.min(0, ...points.map(a => a[k])), Math.max(1, ...points.map(a => a[k]))])
      const size = Math.max(...ends.map(e => e[1] - e[0])), middle = ends.map(e => (e[0] + e[1]) / 2)
      const box = ends.map((e, k) => (e[1] - e[0] < .2 * size ? [middle[k] - .1 * size, middle[k] + .1 * size] : e))
      const cy = Math.cos(state.yaw), sy = Math.sin(state.yaw), cp = Math.cos(state.pitch), sp = Math.sin(state.pitch), s = 290 * state.near / size
      const project = a => { const e = a[0] - middle[0], m = a[1] - middle[1], z = a[2] - middle[2], far = e * sy + m * cy
         return [230 + s * (e * cy - m * sy), 180 + s * (z * cp - far * sp), far] }
      const line = (a, b, o) => { const [x1, y1] = project(a), [x2, y2] = project(b); return make(svg, 'line', {x1, y1, x2, y2, ...o}) }
      const [e0, e1] = box[0], [n0, n1] = box[1], z1 = box[2][1], length = factor('length')
      const plan = sp > .7, few = (a, b, room = 60) => Math.min(5, Math.max(1, Math.round((b - a) * s / room)))   // [px]
      const number = (a, t, look) => { const [x, y] = project(a); make(svg, 'text', {x: x + look.dx, y: y + look.dy, 'text-anchor': look.anchor}, t) }
      const below = {dx: 0, dy: 16, anchor: 'middle'}
      for (const t of ticks(e0 * length, e1 * length, few(e0, e1))) { line([t / length, n0, z1], [t / length, n1, z1], {class: 'grid'})
         if (plan || Math.abs(cy) > .95 && sp < .1) number([t / length, n0, z1], t, below) }
      for (const t of ticks(n0 * length, n1 * length, few(n0, n1))) { line([e0, t / length, z1], [e1, t / length, z1], {class: 'grid'})
         if (plan) number([e0, t / length, z1], t, {dx: -8, dy: 4, anchor: 'end'}); else if (Math.abs(sy) > .95 && sp < .1) number([e1, t / length, z1], t, below) }
      if (!plan) for (const t of ticks(0, z1 * length, few(0, z1 * cp, 25))) { line([e0, n1, t / length], [e1, n1, t / length], {class: 'grid'})
         number([e1, n1, t / length], t, {dx: cy * (e1 - e0) > Math.abs(sy) * (n1 - n0) * .2 ? 34 : -8, dy: 4, anchor: 'end'}) }
      const [ox, oy] = project(middle)                          // a compass away from the string
      for (const [a, t] of [[[size, 0, 0], 'E'], [[0, size, 0], 'N']]) {
         const [x, y] = project(a.map((v, k) => v + middle[k])), dx = (x - ox) / (s * size) * 22, dy = (y - oy) / (s * size) * 22
         if (Math.hypot(dx, dy) < 5) continue
         make(svg, 'line', {x1: 415, y1: 365, x2: 415 + dx, y2: 365 + dy, class: 'zero'})
         make(svg, 'text', {x: 415 + 1.5 * dx, y: 369 + 1.5 * dy, 'text-anchor': 'middle', class: 'label'}, t)
      }
      make(svg, 'path', {class: 'shadow', d: 'M' + points.map(a => { const [x, y] = project([a[0], a[1], z1]); return x.toFixed(1) + ' ' + y.toFixed(1) }).join('L')})
      const values = points.map((a, i) => value_at(p, state.tint, i / n * end)), finite = values.filter(isFinite)
      const sorted = [...finite].sort((a, b) => a - b), low = sorted[0], high = sorted[Math.floor(.99 * (sorted.length - 1))]
      for (let i = 0; i < n; i++) line(points[i], points[i + 1], {stroke: isFinite(values[i]) ? colour((values[i] - low) / (high - low || 1)) : '#888', 'stroke-width': 5, 'stroke-linecap': 'round'})
      for (let i = 0; i < 40; i++) make(svg, 'rect', {x: 20 + 5 * i, y: 372, width: 5.5, height: 9, fill: colour(i / 39)})
      make(svg, 'text', {x: 20, y: 394}, text_of(low, q)); make(svg, 'text', {x: 220, y: 394, 'text-anchor': 'end'}, (sorted[sorted.length - 1] > high ? '\u2265 ' : '') + text_of(high, q))
      make(svg, 'text', {x: 20, y: 366}, `${column(state.tint).label} [${unit(q)}], ${name_of(p)}`.slice(0, 60))
      const dot = make(svg, 'circle', {r: 6, class: 'dot'}), words = make(svg, 'text', {class: 'value'})
      view.mark3d = () => { const [x, y] = project(['east', 'north', 'tvd'].map(a => value_at(p, a, Math.min(state.depth, end))))
         dot.setAttribute('cx', x); dot.setAttribute('cy', y); words.setAttribute('x', x + 9); words.setAttribute('y', y - 6)
         words.textContent = b.place_text() + ': ' + text_of(value_at(p, state.tint, state.depth), q) }
      view.mark3d()
      svg.nearest = (mx, my) => { let best = 0, least = Infinity; points.forEach((a, i) => { const [x, y] = project(a), r = (x - mx) ** 2 + (y - my) ** 2; if (r < least) { least = r; best = i } })
         return least < 400 ? best / n * end : null }
   }

   function draw_assembly() {                                   // the lowest 40 m from the side, high side up
      const svg = view.assembly, p = shown()[0], W = Math.max(320, root.clientWidth || 1000), T = 290
      svg.replaceChildren()
      svg.setAttribute('viewBox', `0 0 ${W} ${T}`)
      if (!p) return
      const bit = D.cases[p.case].depth, long = shown_length, x_of = d => 10 + (d - (bit - long)) / long * (W - 30)
      const hole = value_at(p, 'hole', bit), y = v => T / 2 - v / hole * 150
      const off = d => value_at(p, 'displacement', d) * Math.cos(value_at(p, 'clock', d) * Math.PI / 180)
      const taken = []                                          // places of texts, the first come first served
      const label = (x, y, text) => {
         const half = 3.6 * text.length, at = Math.min(Math.max(x, half), W - half)
         if (taken.some(t => t.y === y && Math.abs(t.at - at) < t.half + half + 4)) return
         taken.push({at, half, y})
         make(svg, 'text', {x: at, y, 'text-anchor': 'middle'}, text)
      }
      const wall = [1, -1].map(sign => Array.from({length: 81}, (_, i) => { const d = bit - long + i * long / 80; return x_of(d).toFixed(1) + ' ' + y(sign * value_at(p, 'hole', d) / 2).toFixed(1) }).join('L'))
      for (const w of wall) make(svg, 'path', {d: 'M' + w, class: 'wall'})
      for (const part of D.cases[p.case].parts) {
         const from = Math.max(bit - part.to, bit - long), to = bit - part.from
         if (to <= bit - long) continue
         const at = Array.from({length: 41}, (_, i) => from + (to - from) * i / 40)
         const edge = sign => at.map(d => x_of(d).toFixed(1) + ' ' + y(off(d) + sign * part.od / 2).toFixed(1))
         make(make(svg, 'path', {d: 'M' + edge(1).concat(edge(-1).reverse()).join('L') + 'z', class: 'body'}), 'title', {}, part.name)
         label((x_of(from) + x_of(to)) / 2, 14, part.name)
      }
      for (const t of ticks(0, long * factor('length'), W / 120)) label(x_of(bit - t / factor('length')), T - 4, String(t))
      const contacts = (p.contacts ?? []).filter(c => c[0] > bit - long).sort((a, b) => b[1] - a[1])
      for (const [d, force, angle] of contacts) {
         const side = Math.cos(angle * Math.PI / 180) < 0 ? -1 : 1, y0 = y(side * hole / 2), h = side * (8 + 20 * force / contacts[0][1])
         make(svg, 'line', {x1: x_of(d), x2: x_of(d), y1: y0 - h, y2: y0, class: 'force'})
         label(x_of(d), side < 0 ? T - 24 : 36, text_of(force, 'force'))
      }
      view.scale.textContent = `The lowest ${round_text(long)}: distance above the bit [${unit('length')}], contact forces [${unit('force')}], enlarged across the hole.`
   }

   const lower = make(root, 'h:div', {class: 'lower'})
   view.section = make(make(lower, 'h:figure', {}), 'svg', {viewBox: '0 -6 200 200', role: 'img', 'aria-label': 'string in the hole at this depth'})
   const well = make(lower, 'h:figure', {}), pick = make(well, 'h:select', {'aria-label': 'colour of the well', onchange: e => { state.tint = e.target.value; draw_3d() }})
   for (const n in D.columns) if (!D.columns[n].words) make(pick, 'h:option', {value: n, ...(n === state.tint ? {selected: ''} : {})}, D.columns[n].label)
   const sides = {'3D': [-0.6, 0.35], plan: [0, Math.PI / 2], 'from south': [0, 0], 'from east': [-Math.PI / 2, 0]}
   for (const name in sides) make(well, 'h:button', {type: 'button', onclick: () => { [state.yaw, state.pitch] = sides[name]; draw_3d() }}, name)
   view.well = make(well, 'svg', {viewBox: '0 0 460 400', role: 'img', 'aria-label': 'the well in three dimensions', tabindex: 0})
   const assembly = make(root, 'h:figure', {})
   view.assembly = make(assembly, 'svg', {role: 'img', 'aria-label': 'lowest part of the string in the hole'})
   view.scale = make(assembly, 'h:figcaption', {})
   let turn = null
   view.well.addEventListener('pointerdown', e => { turn = [e.clientX, e.clientY]; view.well.setPointerCapture(e.pointerId) })
   view.well.addEventListener('pointermove', e => {
      if (turn) { state.yaw += (e.clientX - turn[0]) / 150; state.pitch = Math.min(1.5, Math.max(-1.5, state.pitch + (e.clientY - turn[1]) / 150)); turn = [e.clientX, e.clientY]; draw_3d(); return }
      const r = view.well.getBoundingClientRect(), d = view.well.nearest?.((e.clientX - r.left) / r.width * 460, (e.clientY - r.top) / r.height * 400)
      if (d !== null && d !== undefined) b.set_depth(d)
   })
   view.well.addEventListener('pointerup', () => turn = null)
   view.well.addEventListener('wheel', e => { e.preventDefault(); state.near *= e.deltaY < 0 ? 1.15 : 1 / 1.15; draw_3d() }, {passive: false})
   view.well.addEventListener('keydown', e => { const k = {ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, -.1], ArrowDown: [0, .1]}[e.key]; if (k) { e.preventDefault(); state.yaw += k[0]; state.pitch += k[1]; draw_3d() } })
   return {draw: () => { draw_3d(); draw_assembly() }, draw_assembly, mark: () => { view.mark3d?.(); draw_section() }}
}
