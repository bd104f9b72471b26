// The well of the load cases that are shown, below their curves: the hole across at the depth that is pointed at, the well in three
// dimensions, the assembly in its hole. Part of page.js, which makes a block `b` with curves and calls it.
function well_figures(b) {
   const {root, state, shown} = b
   const angle = (p, d) => {                                    // a row on the axis of the hole has none
      const {clock} = p.curves, i = row_at(clock, d), off = k => value_at(p, 'displacement', clock.d[k]) > 0
      return (off(i) && off(i + 1) ? value_at(p, 'clock', d) : clock.v[off(i) ? i : i + 1]) * Math.PI / 180
   }
   const leading = () => shown().find(p => p.contacts) ?? shown()[0]     // contacts are known to gap elements alone
   const lower = make(root, 'h:div', {class: 'lower'})
   const picture = (parent, label, more) => make(make(parent, 'h:figure', {}), 'svg', {role: 'img', 'aria-label': label, ...more})
   const section = picture(lower, 'string in the hole at this depth', {viewBox: '0 -6 200 214'})
   const well = picture(lower, 'the well in three dimensions', {viewBox: '0 0 460 440', tabindex: 0})
   const assembly = picture(root, 'lowest part of the string in the hole'), scale = make(assembly.parentNode, 'h:figcaption', {})
   const pick = make(null, 'h:select', {'aria-label': 'colour of the well', onchange: () => { state.tint = pick.value; draw() }})
   const colour = part => `hsl(${230 - 225 * Math.min(part, 1)} 75% 48%)`     // blue, green, yellow, red
   let marks = []                                               // each moves the sign of the depth in a picture
   function writer(svg, width) {                                // writes texts, each unless it would hide an earlier one: false
      const taken = []
      return (x, y, text) => {
         const half = 3.6 * text.length, at = Math.min(Math.max(x, half), width - half)
         if (taken.some(t => Math.abs(t.y - y) < 13 && Math.abs(t.at - at) < t.half + half + 4)) return false
         taken.push({at, half, y})
         make(svg, 'text', {x: at, y, 'text-anchor': 'middle'}, text)
         return true
      }
   }
   function draw_section() {                                    // the hole at the depth, seen down the hole, high side up
      section.replaceChildren()
      make(section, 'circle', {cx: 100, cy: 100, r: 88, class: 'wall'})
      make(section, 'text', {x: 100, y: 9, 'text-anchor': 'middle'}, 'high side')
      make(section, 'text', {x: 100, y: 204, 'text-anchor': 'middle'}, 'at ' + b.place_text())
      for (const p of shown().filter(p => state.depth <= D.cases[p.case].depth)) {
         const scale = 88 / value_at(p, 'hole', state.depth)
         const off = value_at(p, 'displacement', state.depth) * 2 * scale, a = angle(p, state.depth)
         const circle = {cx: 100 + off * Math.sin(a), cy: 100 - off * Math.cos(a), r: value_at(p, 'od', state.depth) * scale}
         make(section, 'circle', {...circle, fill: 'none', 'stroke-width': 2, ...b.key_of(p).look})
      }
   }
   function draw_well() {
      const p = leading(), place = d => ['east', 'north', 'tvd'].map(name => value_at(p, name, d))
      well.replaceChildren()
      if (!p) return () => {}
      const end = D.cases[p.case].depth, n = 400, {label, quantity, words} = D.columns[state.tint]
      const depths = Array.from({length: n + 1}, (_, i) => i / n * end)
      const points = depths.map(d => ({d, at: place(d), value: value_at(p, state.tint, d)}))
      const ends = [0, 1, 2].map(k => [Math.min(0, ...points.map(a => a.at[k])), Math.max(1, ...points.map(a => a.at[k]))])
      const size = Math.max(...ends.map(e => e[1] - e[0])), middle = ends.map(e => (e[0] + e[1]) / 2)
      const least = .1 * size, apart = (e, k) => (e[1] - e[0] < 2 * least ? [middle[k] - least, middle[k] + least] : e)
      const [[e0, e1], [n0, n1], [, z1]] = ends.map(apart), s = 290 / size
      const cy = Math.cos(state.yaw), sy = Math.sin(state.yaw), cp = Math.cos(state.pitch), sp = Math.sin(state.pitch)
      const project = a => {
         const e = a[0] - middle[0], m = a[1] - middle[1], z = a[2] - middle[2]
         return [230 + s * (e * cy - m * sy), 180 + s * (z * cp - (e * sy + m * cy) * sp)]
      }
      const line = (a, b, look) => make(well, 'path', {d: 'M' + [a, b].map(project).join('L'), ...look})
      const write = writer(well, 460), sorted = points.map(a => a.value).filter(isFinite).sort((a, b) => a - b)
      const low = words ? 0 : sorted[0], high = words ? words.length - 1 : sorted[Math.floor(.99 * (sorted.length - 1))]
      const beyond = sorted[sorted.length - 1] > high ? '\u2265 ' : ''
      for (let i = 0; i < 40; i++) make(well, 'rect', {x: 20 + 5 * i, y: 412, width: 5.5, height: 9, fill: colour(i / 39)})
      write(120, 434, words ? words.join(', ') : text_of(low, quantity) + ' to ' + beyond + text_of(high, quantity))
      write(0, 406, (label + (unit(quantity) && ` [${unit(quantity)}]`) + ', ' + p.key.text).slice(0, 60))
      const labels = []                                         // on top of all lines
      const grid = (name, axis, from, to, ...edges) => {        // lines across an axis, none where it is seen from its end
         const low = edge => project(edge.map((v, k) => (k === axis ? (from + to) / 2 : v)))[1]
         const [corner, other] = edges.sort((a, b) => low(b) - low(a))      // labels at the edge in front
         const at = (t, point) => point.map((v, k) => (k === axis ? t : v)), length = factor('length')
         const [[x1, y1], [x2, y2]] = [from, to].map(t => project(at(t, corner)))
         const few = Math.min(5, Math.round(Math.hypot(x2 - x1, y2 - y1) / 40))
         if (few) for (const t of ticks(from * length, to * length, few)) {
            const [x, y] = project(at(t / length, corner))
            line(at(t / length, corner), at(t / length, other), {class: 'grid'})
            const flat = Math.abs(x2 - x1) > Math.abs(y2 - y1), aside = x < 230 ? -30 : 30
            labels.push([flat ? x : x + aside, flat ? y + 18 : y + 4, name + t])
         }
      }
      grid('', 2, 0, z1, [e1, n1, 0], [e0, n1, 0])
      grid('E ', 0, e0, e1, [0, n0, z1], [0, n1, z1])
      grid('N ', 1, n0, n1, [e0, 0, z1], [e1, 0, z1])
      make(well, 'path', {class: 'shadow', d: 'M' + points.map(a => project([a.at[0], a.at[1], z1])).join('L')})
      points.slice(0, n).forEach((a, i) => {
         const stroke = isFinite(a.value) ? colour((a.value - low) / (high - low || 1)) : '#888'
         line(a.at, points[i + 1].at, {stroke, 'stroke-width': 5, 'stroke-linecap': 'round', 'pointer-events': 'none'})
         line(a.at, points[i + 1].at, {class: 'near', onpointerenter: () => b.set_depth(a.d)})
      })
      for (const label of labels) write(...label)
      const dot = make(well, 'g', {})
      const said = () => words ? word_at(p, state.tint, state.depth) : text_of(value_at(p, state.tint, state.depth), quantity)
      return () => {
         const [x, y] = project(place(state.depth))
         dot.replaceChildren()
         if (state.depth > end) return
         make(dot, 'circle', {cx: x, cy: y, r: 6, class: 'dot'})
         const text = b.place_text() + ': ' + said(), half = 4 * text.length      // above the string, labels are below; within the picture
         make(dot, 'text', {x: Math.min(Math.max(x, half), 460 - half), y: Math.max(11, y - 12), class: 'value', 'text-anchor': 'middle'}, text)
      }
   }
   function draw_assembly() {                                   // the lowest 40 m from the side, high side up
      const p = leading(), W = paper?.wide ?? Math.max(320, root.clientWidth || 1000), T = paper ? 190 : 290
      assembly.replaceChildren()
      if (!p) return () => {}
      const bit = D.cases[p.case].depth, top = bit - shown_length, x_of = d => 10 + (d - top) / shown_length * (W - 30)
      const hole = value_at(p, 'hole', bit), y_of = v => T / 2 - v / hole * (T - 110) / 1.2
      const off = d => value_at(p, 'displacement', d) * Math.cos(angle(p, d))
      const point = (x, y) => `${x.toFixed(1)} ${y.toFixed(1)}`
      const between = (from, to, n) => [...Array(n + 1).keys()].map(i => from + (to - from) * i / n)
      const edge = (from, to, v_of) => between(from, to, 80).map(d => point(x_of(d), y_of(v_of(d))))
      const write = writer(assembly, W), start = Math.max(top, p.curves.hole.d[0])
      const said = (name, v) => `${text_of(v, D.columns[name].quantity)} ${unit(D.columns[name].quantity)}`
      for (const side of [.5, -.5]) {
         make(assembly, 'path', {d: 'M' + edge(start, bit, d => side * value_at(p, 'hole', d)).join('L'), class: 'wall'})
      }
      let row = 0                                               // of the uppermost name: short parts stand close together
      for (const part of D.cases[p.case].parts) {
         const from = Math.max(bit - part.to, top), to = bit - part.from
         if (to <= top) continue
         const body = [...edge(from, to, d => off(d) + part.od / 2), ...edge(to, from, d => off(d) - part.od / 2)]
         make(make(assembly, 'path', {d: 'M' + body.join('L') + 'z', class: 'body'}), 'title', {}, part.name)
         row = Math.max(row, [0, 1, 2, 3].findIndex(k => write((x_of(from) + x_of(to)) / 2, 14 - 13 * k, part.name)))
      }
      assembly.setAttribute('viewBox', `0 ${-13 * row} ${W} ${T + 84 + 13 * row}`)
      for (const t of ticks(0, shown_length * factor('length'), W / 120)) write(x_of(bit - t / factor('length')), T - 4, String(t))
      const contacts = (p.contacts ?? []).filter(c => c[0] > top && c[1] > 0).sort((a, b) => b[1] - a[1])
      for (const [d, force, clock] of contacts) {
         const side = Math.cos(clock * Math.PI / 180) < 0 ? -1 : 1, y2 = y_of(side * hole / 2)
         const y1 = y2 - side * (8 + 20 * force / contacts[0][1])
         make(assembly, 'line', {x1: x_of(d), x2: x_of(d), y1, y2, class: 'force'})
         write(x_of(d), side < 0 ? T - 24 : 36, text_of(force, 'force'))
      }
      const own = p.curves.bending.d.filter(d => d >= start && d <= bit)                 // a peak is one of its points
      const moments = [...new Set([...between(start, bit, 200), ...own])].sort((a, b) => a - b)
         .map(d => [x_of(d), value_at(p, 'bending', d)]).filter(([, m]) => isFinite(m))
      const most = Math.max(...moments.map(([, m]) => m), 0)   // of the moments, in a strip of their own
      const places = moments.map(([x, m]) => point(x, T + 80 - m / (most || 1) * 60))
      make(assembly, 'path', {d: 'M' + places.join('L'), class: 'moment'})
      write(0, T + 14, 'moment, at most ' + said('bending', most))
      const cross = make(assembly, 'path', {class: 'cross'})
      const words = `The ${lowest()}, ${p.key.text}, enlarged across the hole. Distance above the bit [${unit('length')}]` +
         (p.contacts ? `, contact forces [${unit('force')}].` : '.')
      return () => {
         const there = state.depth >= top && state.depth <= bit
         cross.setAttribute('d', there ? `M${x_of(state.depth)} 20V${T + 80}` : '')
         const values = ['bending', 'displacement'].map(name => said(name, value_at(p, name, state.depth)))
         scale.textContent = words + (there ? ` At ${b.place_text()}: moment ${values.join(', ')} off the axis.` : '')
      }
   }
   const mark = () => { for (const m of marks) m() }
   const draw = () => { marks = [draw_well(), draw_assembly(), draw_section]; mark() }
   for (const n in D.columns) make(pick, 'h:option', {value: n}, D.columns[n].label)
   pick.value = state.tint
   well.before(pick)
   const turn_by = (x, y) => { state.yaw += x; state.pitch = Math.min(1.5, Math.max(-1.5, state.pitch + y)); draw() }
   const sides = {'3D': [-0.6, 0.35], plan: [0, Math.PI / 2], 'from south': [0, 0], 'from east': [-Math.PI / 2, 0]}
   for (const name in sides) {
      const turn = () => { [state.yaw, state.pitch] = sides[name]; draw() }
      well.before(make(null, 'h:button', {type: 'button', onclick: turn}, name))
   }
   well.addEventListener('pointermove', e => { if (e.buttons) turn_by(e.movementX / 150, e.movementY / 150) })
   well.addEventListener('keydown', e => {
      const by = {ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, -.1], ArrowDown: [0, .1]}[e.key]
      if (by) { e.preventDefault(); turn_by(...by) }
   })
   return {draw, mark}
}
