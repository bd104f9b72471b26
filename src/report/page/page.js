// Interactive part of a report: no library, nothing fetched. All that is shown stands in the page's data (id="data"):
// D.columns, D.quantities, D.profiles (thinned curves), D.charts (which curve stands in which panel). Numbers are in D.units.
'use strict'
const D = JSON.parse(document.getElementById('data').textContent)
const root = document.getElementById('live'), NS = 'http://www.w3.org/2000/svg'
const colours = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#56B4E9', '#E69F00', '#7f6fd0', '#999999']
const dashes = ['', '8 4', '2 3', '8 3 2 3']
const state = {cases: [D.start], models: [0, 1].filter(i => i < D.models.length), chart: 0, top: 0, bottom: 0, depth: 0, units: D.systems.includes(D.units) ? D.units : D.systems[0],
   tint: 'side_force_on_joint', yaw: -0.6, pitch: 0.35, near: 1, hidden: new Set()}

// ---- data
for (const p of D.profiles) for (const name in p.curves) {   // "step value step value ..." in thousandths of D.units' length
   if (typeof p.curves[name] === 'number') { p.curves[name] = D.profiles[p.curves[name]].curves[name]; continue }   // the same as an earlier one
   const t = p.curves[name].split(' '), n = t.length / 2, d = new Float64Array(n), v = new Float64Array(n)
   for (let i = 0, sum = 0; i < n; i++) { d[i] = (sum += +t[2 * i]) / 1000; v[i] = t[2 * i + 1] === '' ? NaN : +t[2 * i + 1] }
   p.curves[name] = {d, v}
}
const column = name => D.columns[name]
const factor = q => D.quantities[q]?.[state.units]?.[1] ?? 1, unit = q => D.quantities[q]?.[state.units]?.[0] ?? q
const shown = () => D.profiles.filter(p => state.cases.includes(p.case) && state.models.includes(p.model))
function row_at(c, depth) {                                  // last row at or above a depth
   let low = 0, high = c.d.length - 1
   while (high - low > 1) { const m = (low + high) >> 1; if (c.d[m] <= depth) low = m; else high = m }
   return low
}
function value_at(p, name, depth) {
   const c = p.curves[name]
   if (!c || depth < c.d[0] || depth > c.d[c.d.length - 1]) return NaN
   const i = row_at(c, depth), step = c.d[i + 1] - c.d[i]
   if (column(name).words) return c.v[depth - c.d[i] < c.d[i + 1] - depth ? i : i + 1]
   let turn = c.v[i + 1] - c.v[i]
   if (name === 'clock') turn = ((turn + 540) % 360) - 180   // the short way round
   const v = c.v[i] + (step > 0 ? (depth - c.d[i]) / step * turn : 0)
   return name === 'clock' ? (v + 360) % 360 : v
}
const deepest = () => Math.max(...(state.cases.length ? state.cases : [D.start]).map(i => D.cases[i].depth))
function text_of(value, q) {
   if (!isFinite(value)) return '\u2013'
   const v = value * factor(q), a = Math.abs(v)
   return v.toFixed(a >= 1000 ? 0 : a >= 100 ? 1 : a >= 10 ? 2 : 3)
}
const look_of = p => ({stroke: colours[(state.cases.length > 1 ? state.cases.indexOf(p.case) : p.model) % 8], 'stroke-dasharray': dashes[p.model]})
const name_of = p => D.cases[p.case].name + ' ' + D.models[p.model]

// ---- drawing
function make(parent, tag, attributes, text) {
   const e = tag.startsWith('h:') ? document.createElement(tag.slice(2)) : document.createElementNS(NS, tag)
   for (const k in attributes) if (k.startsWith('on')) e.addEventListener(k.slice(2), attributes[k]); else e.setAttribute(k, attributes[k])
   if (text !== undefined) e.textContent = text
   parent?.append(e)
   return e
}
function ticks(low, high, most) {
   const raw = (high - low) / most, power = 10 ** Math.floor(Math.log10(raw)), step = power * [1, 2, 5, 10].find(f => f * power >= raw)
   const list = []
   for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) list.push(+(i * step).toPrecision(12))
   return list
}
const H = 420, up = 30, down = 26
let clips = 0
const y_of = depth => up + (depth - state.top) / (state.bottom - state.top) * (H - up - down)
const depth_of = y => state.top + (y - up) / (H - up - down) * (state.bottom - state.top)
function panel_curves(panel) {
   const list = []
   for (const p of shown()) for (const c of panel.curves) if (p.curves[c.column] && (!c.limit || p === shown()[0]))
      list.push({p, c, sign: c.sign ?? 1, curve: p.curves[c.column]})
   return list
}
// A line of no more than four points a pixel of depth: first, least, greatest and last (to and fro within a pixel is a bar).
function path_of(curve, [from, to], x_of, turns) {
   let path = '', gap = true, at = NaN, few = []
   const flush = () => {
      if (few.length > 4) {
         const x = few.map(a => a[0]), least = x.indexOf(Math.min(...x)), most = x.indexOf(Math.max(...x))
         few = [...new Set([0, least, most, few.length - 1])].sort((a, b) => a - b).map(i => few[i])
      }
      for (const [x, y] of few) { path += (gap ? 'M' : 'L') + x.toFixed(1) + ' ' + y.toFixed(1); gap = false }
      few = []
   }
   for (let i = from; i < to; i++) {
      if (!isFinite(curve.v[i])) { flush(); gap = true; continue }
      if (turns && i && Math.abs(curve.v[i] - curve.v[i - 1]) > 180) { flush(); gap = true }
      const y = y_of(curve.d[i]), row = Math.round(y)
      if (row !== at) { flush(); at = row }
      few.push([x_of(curve.v[i]), y])
   }
   flush()
   return path
}
function draw_panel(panel, index, width) {
   const svg = make(null, 'svg', {viewBox: `0 0 ${width} ${H}`, role: 'img', 'aria-label': panel.label, class: 'panel'})
   const left = index ? 12 : 46, right = width - 10, q = column(panel.curves[0].column).quantity, f = factor(q)
   const lists = panel_curves(panel), rows = []
   let low = panel.low ?? 0, high = panel.high ?? 0
   for (const {c, curve, sign} of lists) {
      let from = row_at(curve, state.top), to = Math.min(curve.d.length, row_at(curve, state.bottom) + 2)
      rows.push([from, to])
      if (!c.limit && panel.high === undefined) for (let i = from; i < to; i++)
         if (isFinite(curve.v[i])) { low = Math.min(low, sign * curve.v[i]); high = Math.max(high, sign * curve.v[i]) }
   }
   if (panel.high === undefined) { if (high === low) { low--; high++ } const air = (high - low) * .05; if (low < 0) low -= air; high += air }
   if (panel.most) high = Math.min(high, panel.most)
   low *= f; high *= f
   const x_of = v => left + (v * f - low) / (high - low) * (right - left)
   make(make(svg, 'clipPath', {id: 'clip' + ++clips}), 'rect', {x: left, y: up, width: right - left, height: H - up - down})
   for (const t of panel.ticks ?? ticks(low, high, Math.max(3, (right - left) / 50))) {
      const x = left + (t - low) / (high - low) * (right - left)
      make(svg, 'line', {x1: x, x2: x, y1: up, y2: H - down, class: t ? 'grid' : 'zero'})
      make(svg, 'text', {x, y: H - down + 15, 'text-anchor': 'middle'}, t)
   }
   const length = factor('length')
   for (const t of ticks(state.top * length, state.bottom * length, 9)) {
      const y = y_of(t / length)
      make(svg, 'line', {x1: left, x2: right, y1: y, y2: y, class: 'grid'})
      if (!index) make(svg, 'text', {x: left - 4, y: y + 4, 'text-anchor': 'end'}, t)
   }
   make(svg, 'rect', {x: left, y: up, width: right - left, height: H - up - down, class: 'frame'})
   make(svg, 'text', {x: left, y: 12, class: 'label'}, panel.label)
   make(svg, 'text', {x: left, y: 25}, unit(q) ? `[${unit(q)}]` : '')
   const clip = make(svg, 'g', {'clip-path': `url(#clip${clips})`})
   lists.forEach(({p, c, curve, sign}, k) => {
      if (state.hidden.has(name_of(p))) return
      const path = path_of(curve, rows[k], v => x_of(sign * v), panel.turn)
      const look = c.limit ? {stroke: 'currentColor', 'stroke-dasharray': '2 3', 'stroke-width': 1} : look_of(p)
      make(clip, 'path', {d: path, fill: 'none', 'stroke-width': 1.7, ...look})
   })
   const cross = make(svg, 'g', {class: 'cross'})
   svg.cross = () => {
      cross.replaceChildren()
      if (state.depth < state.top || state.depth > state.bottom) return
      const y = y_of(state.depth)
      make(cross, 'line', {x1: left, x2: right, y1: y, y2: y})
      let k = 0
      for (const {p, c, sign} of lists) {
         const v = value_at(p, c.column, state.depth)
         if (!isFinite(v) || c.limit || state.hidden.has(name_of(p))) continue
         const x = x_of(sign * v)
         if (x >= left && x <= right) make(cross, 'circle', {cx: x, cy: y, r: 3.5, fill: look_of(p).stroke})
         make(cross, 'text', {x: right - 3, y: (y < 100 ? y + 14 : y - 5) + (y < 100 ? 1 : -1) * 13 * k++, 'text-anchor': 'end', style: 'fill:' + look_of(p).stroke, class: 'value'}, text_of(sign * v, q))
      }
      if (!index) make(cross, 'text', {x: left + 3, y: y < 100 ? y + 14 : y - 5, class: 'value'}, text_of(state.depth, 'length') + ' ' + unit('length'))
   }
   return svg
}
const view = {}
function draw_panels() {
   const chart = D.charts[state.chart], many = chart.panels.length, bare = !shown().length
   root.classList.toggle('bare', bare)                       // an empty chart is not drawn
   if (bare) {
      const names = state.cases.map(i => D.cases[i].name).join(', ')
      view.panels.replaceChildren(make(null, 'h:p', {class: 'note'}, state.cases.length * state.models.length
         ? `No curves: no solution of ${names}. Answers and warnings above say why.` : 'No curves: choose a load case and a model.'))
      return
   }
   const wide = view.panels.clientWidth || 1000, each = wide < 600 ? wide / 2 : wide / many
   view.panels.replaceChildren(...chart.panels.map((p, i) => draw_panel(p, wide < 600 ? i % 2 : i, Math.max(150, each))))
   for (const s of view.panels.children) s.style.width = wide < 600 ? '50%' : 100 / many + '%'
   draw_cross()
}
function set_depth(depth) {
   const least = state.top, most = state.bottom
   state.depth = Math.min(Math.max(depth, least), most)
   draw_cross()
}
let waiting = false
function draw_cross() {
   if (waiting) return
   waiting = true
   requestAnimationFrame(() => {
      waiting = false
      for (const s of view.panels.children) s.cross()
      view.slider.min = state.top; view.slider.max = state.bottom; view.slider.value = state.depth
      view.slider.setAttribute('aria-valuetext', told()); view.mark3d?.(); draw_section(); draw_readout(); note_address()
   })
}
function told() {                                            // what a screen reader says
   const p = shown()[0]
   return p ? text_of(state.depth, 'length') + ' ' + unit('length') + ', ' + D.charts[state.chart].panels.map(a => a.label + ' ' +
      text_of(value_at(p, a.curves[0].column, state.depth), column(a.curves[0].column).quantity)).join(', ') : ''
}
function draw_readout() {
   const list = shown(), wanted = D.charts[state.chart].panels.flatMap(p => p.curves.map(c => c.column))
   const names = view.all.checked ? Object.keys(D.columns) : [...new Set(wanted)]
   const table = make(null, 'h:table', {}), row = parent => make(parent, 'h:tr', {})
   make(table, 'h:caption', {}, `At ${text_of(state.depth, 'length')} ${unit('length')} measured depth`)
   const head = row(make(table, 'h:thead', {})), body = make(table, 'h:tbody', {})
   make(head, 'h:th', {class: 'text', scope: 'col'}, 'quantity')
   for (const t of ['unit', ...list.map(name_of), ...(list.length === 2 ? ['difference'] : [])]) make(head, 'h:th', {scope: 'col'}, t)
   for (const n of names) {
      const c = column(n), v = list.map(p => value_at(p, n, state.depth)), line = row(body)
      make(line, 'h:td', {class: 'text', title: c.meaning}, c.label)
      make(line, 'h:td', {}, unit(c.quantity))
      for (const x of v) make(line, 'h:td', {}, c.words ? c.words[x] ?? '\u2013' : text_of(x, c.quantity))
      if (list.length === 2) make(line, 'h:td', {}, c.words ? '' : text_of(v[1] - v[0], c.quantity))
   }
   view.readout.replaceChildren(table)
}
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

// ---- the well in three dimensions
function colour(t) {                                         // dark blue, green, yellow, red
   const stops = [[70, 100, 215], [20, 145, 140], [120, 190, 70], [245, 215, 60], [210, 50, 30]], x = Math.min(Math.max(t, 0), 1) * 4, i = Math.min(3, Math.floor(x))
   return 'rgb(' + stops[i].map((a, k) => Math.round(a + (stops[i + 1][k] - a) * (x - i))).join() + ')'
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
   const dot = make(svg, 'circle', {r: 6, class: 'dot'}), told = make(svg, 'text', {class: 'value'})
   view.mark3d = () => { const [x, y] = project(['east', 'north', 'tvd'].map(a => value_at(p, a, Math.min(state.depth, end))))
      dot.setAttribute('cx', x); dot.setAttribute('cy', y); told.setAttribute('x', x + 9); told.setAttribute('y', y - 6)
      told.textContent = text_of(state.depth, 'length') + ' ' + unit('length') + ': ' + text_of(value_at(p, state.tint, state.depth), q) }
   view.mark3d()
   svg.nearest = (mx, my) => { let best = 0, least = Infinity; points.forEach((a, i) => { const [x, y] = project(a), r = (x - mx) ** 2 + (y - my) ** 2; if (r < least) { least = r; best = i } })
      return least < 400 ? best / n * end : null }
}

// ---- the assembly in its hole: the lowest 40 m from the side, high side up
const shown_length = 40 / D.quantities.length.SI[1]
function draw_assembly() {
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
   view.scale.textContent = `The lowest ${text_of(long, 'length').replace(/\.0+$/, '')} ${unit('length')}: distance above the bit [${unit('length')}], contact forces [${unit('force')}], enlarged across the hole.`
}

// ---- the page
function draw() {
   const end = deepest()
   if (!(state.bottom > state.top) || state.bottom > end) { state.top = 0; state.bottom = end }
   state.depth = Math.min(state.depth, state.bottom)
   view.legend.replaceChildren()
   for (const p of shown()) {
      const b = make(view.legend, 'h:button', {type: 'button', 'aria-pressed': !state.hidden.has(name_of(p)), onclick: () => { const n = name_of(p); state.hidden.has(n) ? state.hidden.delete(n) : state.hidden.add(n); draw() }})
      make(make(b, 'svg', {viewBox: '0 0 28 8', class: 'key'}), 'line', {x1: 0, x2: 28, y1: 4, y2: 4, 'stroke-width': 3, ...look_of(p)})
      b.append(name_of(p) + (D.cases[p.case].converged ? '' : ' (no equilibrium)'))
   }
   draw_panels(); draw_3d(); draw_assembly()
}
function choice(parent, label, names, list) {                // check boxes
   const box = make(parent, 'h:fieldset', {})
   make(box, 'h:legend', {}, label)
   names.forEach((n, i) => {
      const l = make(box, 'h:label', {}), c = make(l, 'h:input', {type: 'checkbox', onchange: () => {
         if (c.checked) list.push(i); else list.splice(list.indexOf(i), 1)
         draw() }})
      c.checked = list.includes(i)
      l.append(' ' + n)
   })
}
function build() {
   const bar = make(root, 'h:div', {class: 'bar'})
   D.charts.forEach((c, i) => { const b = make(bar, 'h:button', {type: 'button', 'aria-pressed': i === state.chart, onclick: () => { state.chart = i; for (const o of bar.querySelectorAll('.tab')) o.setAttribute('aria-pressed', o === b); draw() }, class: 'tab'}, c.title) })
   const units = make(bar, 'h:button', {type: 'button', onclick: () => { state.units = D.systems[(D.systems.indexOf(state.units) + 1) % D.systems.length]; units.textContent = 'units: ' + state.units; draw() }}, 'units: ' + state.units)
   make(bar, 'h:button', {type: 'button', onclick: () => { state.top = 0; state.bottom = deepest(); draw() }}, 'whole depth')
   make(bar, 'h:button', {type: 'button', onclick: () => { state.bottom = deepest(); state.top = Math.max(0, state.bottom - shown_length); draw() }}, 'lowest ' + text_of(shown_length, 'length').replace(/\.0+$/, '') + ' ' + unit('length'))
   const main = make(root, 'h:div', {class: 'main'}), side = make(main, 'h:div', {class: 'side'}), right = make(main, 'h:div', {class: 'right'})
   choice(side, 'Load cases', D.cases.map(c => c.name), state.cases)
   choice(side, 'Models', D.models, state.models)
   view.legend = make(right, 'h:div', {class: 'legend'})
   view.panels = make(right, 'h:div', {class: 'panels', id: 'panels'})
   view.slider = make(right, 'h:input', {type: 'range', step: 'any', 'aria-label': 'measured depth', oninput: e => set_depth(+e.target.value)})
   make(right, 'h:p', {class: 'hint'}, 'Point at a depth to read all curves there. Drag up or down, or spread two fingers, to zoom. Double click for the whole depth. Arrow keys move the slider. '
      + `Curves are within ${100 * D.tolerance} % of their range of those in the CSV files.`)
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
   const l = make(root, 'h:label', {})
   view.all = make(l, 'h:input', {type: 'checkbox', onchange: draw_readout}); l.append(' all columns')
   view.readout = make(root, 'h:div', {class: 'wide', id: 'readout'})
   let from = null, band = null
   const y_in = e => { const s = e.target.closest('svg.panel'); if (!s) return null; const r = s.getBoundingClientRect(); return (e.clientY - r.top) / r.height * H }
   const show_band = (a, b) => { for (const s of view.panels.children) { s.band ??= make(s, 'rect', {x: 0, width: '100%', class: 'band'}); s.band.setAttribute('y', Math.min(a, b)); s.band.setAttribute('height', Math.abs(b - a)) } }
   view.panels.addEventListener('pointerdown', e => { const y = y_in(e); if (y === null) return; if (e.pointerType === 'mouse') { from = y; e.preventDefault() } set_depth(depth_of(y)) })
   view.panels.addEventListener('pointermove', e => {
      const y = y_in(e)
      if (y === null) return
      set_depth(depth_of(y))
      if (from !== null) { show_band(from, y); band = y }
   })
   addEventListener('pointerup', () => {
      if (from !== null && band !== null && Math.abs(band - from) > 6) { const a = depth_of(Math.min(from, band)), b = depth_of(Math.max(from, band)); state.top = Math.max(0, a); state.bottom = Math.min(deepest(), b); draw() }
      else if (from !== null) draw_panels()
      from = band = null
   })
   let pinch = null                                          // two fingers: the depths between which they began are spread
   const fingers = e => [...e.touches].map(t => { const r = view.panels.firstChild.getBoundingClientRect(), s = t.target.closest?.('svg.panel')?.getBoundingClientRect() ?? r; return (t.clientY - s.top) / s.height * H }).sort((a, b) => a - b)
   view.panels.addEventListener('touchstart', e => { if (e.touches.length === 2) { e.preventDefault(); pinch = {depths: fingers(e).map(depth_of)} } }, {passive: false})
   view.panels.addEventListener('touchmove', e => {
      if (!pinch || e.touches.length !== 2) return
      e.preventDefault()
      const [a, b] = fingers(e), step = (pinch.depths[1] - pinch.depths[0]) / Math.max(b - a, 20)
      pinch.top = Math.max(0, pinch.depths[0] - step * (a - up)); pinch.bottom = Math.min(deepest(), pinch.top + step * (H - up - down))
      show_band(y_of(pinch.top), y_of(pinch.bottom))
   }, {passive: false})
   view.panels.addEventListener('touchend', () => { if (pinch?.bottom > pinch?.top) { state.top = pinch.top; state.bottom = pinch.bottom; draw() } pinch = null })
   view.panels.addEventListener('dblclick', () => { state.top = 0; state.bottom = deepest(); draw() })
   let turn = null
   view.well.addEventListener('pointerdown', e => { turn = [e.clientX, e.clientY]; view.well.setPointerCapture(e.pointerId) })
   view.well.addEventListener('pointermove', e => {
      if (turn) { state.yaw += (e.clientX - turn[0]) / 150; state.pitch = Math.min(1.5, Math.max(-1.5, state.pitch + (e.clientY - turn[1]) / 150)); turn = [e.clientX, e.clientY]; draw_3d(); return }
      const r = view.well.getBoundingClientRect(), d = view.well.nearest?.((e.clientX - r.left) / r.width * 460, (e.clientY - r.top) / r.height * 400)
      if (d !== null && d !== undefined) set_depth(d)
   })
   view.well.addEventListener('pointerup', () => turn = null)
   view.well.addEventListener('wheel', e => { e.preventDefault(); state.near *= e.deltaY < 0 ? 1.15 : 1 / 1.15; draw_3d() }, {passive: false})
   view.well.addEventListener('keydown', e => { const k = {ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, -.1], ArrowDown: [0, .1]}[e.key]; if (k) { e.preventDefault(); state.yaw += k[0]; state.pitch += k[1]; draw_3d() } })
   let wide = 0
   new ResizeObserver(() => { if (view.panels.clientWidth !== wide) { wide = view.panels.clientWidth; draw_panels(); draw_assembly() } }).observe(view.panels)
   state.bottom ||= deepest(); state.depth ||= state.bottom / 2
   draw()
   document.documentElement.classList.add('scripted')
}
function from_address() {                                     // #case=NAME&case=NAME&chart=TITLE&depth=M&top=M&bottom=M&units=field
   const q = new URLSearchParams(location.hash.slice(1)), found = (list, name) => list.findIndex(c => (c.name ?? c.title ?? c) === name)
   if (q.has('case')) state.cases = q.getAll('case').map(n => found(D.cases, n)).filter(i => i >= 0)
   if (q.has('chart')) state.chart = Math.max(0, found(D.charts, q.get('chart')))
   if (D.systems.includes(q.get('units'))) state.units = q.get('units')
   for (const k of ['depth', 'top', 'bottom']) if (isFinite(parseFloat(q.get(k)))) state[k] = parseFloat(q.get(k))
}
let noting = 0
function note_address() {                                     // after a pause: the view is a link
   clearTimeout(noting)
   noting = setTimeout(() => {
      const q = new URLSearchParams(), end = deepest()
      for (const i of state.cases) q.append('case', D.cases[i].name)
      q.set('chart', D.charts[state.chart].title)
      q.set('depth', +state.depth.toFixed(2))
      if (state.top > 0 || state.bottom < end) { q.set('top', +state.top.toFixed(2)); q.set('bottom', +state.bottom.toFixed(2)) }
      if (state.units !== D.units) q.set('units', state.units)
      history.replaceState(null, '', '#' + q)
   }, 300)
}
addEventListener('hashchange', () => {
   state.top = state.bottom = 0
   from_address()
   root.replaceChildren()
   build()
   root.scrollIntoView()
})
try { from_address(); build() } catch (fault) {              // fixed pictures, as without a script
   root.replaceChildren()
   throw fault
}
