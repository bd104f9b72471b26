// Interactive part of a report: no library, nothing fetched. All that is shown stands in the page's data (id="data"):
// D.columns, D.quantities, D.profiles (thinned curves over shared depths), D.charts (which curve stands in which panel), D.figures (pictures of the
// run: blocks of panels with their own curves). Numbers are in D.units.
'use strict'
const D = JSON.parse(document.getElementById('data').textContent)
const shapes = ['m0-5v10m-5-5h10', 'm-4-4l8 8m0-8l-8 8', 'm0-5v10m-4.3-7.5l8.6 5m0-5l-8.6 5', 'm-4-4h8v8h-8z',
   'm-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z', 'm0-5l5 8.5h-10z', 'm0 5l5-8.5h-10z', 'm0-5.5l4.5 5.5l-4.5 5.5l-4.5-5.5z',
   'm0-5l4.8 3.5l-1.8 5.5h-6l-1.8-5.5z']   // gnuplot's marks
const choices = {case: (D.cases ?? []).map(c => c.name), model: [...new Set((D.profiles ?? []).map(p => p.model))]}
const blocks = []                                            // all charts of the page that answer
const shown_length = 40 / D.quantities.length.SI[1]          // of the assembly in its hole
const lowest = () => `lowest ${Math.round(shown_length * factor('length'))} ${unit('length')}`
let units = D.systems.includes(D.units) ? D.units : D.systems[0], clips = 0, noting = 0, active = null
let paper = null                                             // while the page is printed: width and height of charts

// ---- data
for (const p of D.profiles ?? []) {
   const rows = depths_of((D.profiles[p.depths] ?? p).depths ?? '')     // those of an earlier one by its place
   for (const name in p.curves) {
      const written = p.curves[name], {words, inverse} = D.columns[name]
      if (typeof written === 'number') { p.curves[name] = D.profiles[written].curves[name]; continue }      // the same as an earlier one
      const curve = curve_of(written, rows)
      p.curves[name] = {...(inverse ? inverse_of(curve) : curve), words, turns: name === 'clock'}
   }
}
const mirrored = curve => ({...curve, v: curve.v.map(v => -v)})       // a limit of compression
for (const panel of (D.charts ?? []).flatMap(c => c.panels)) {
   panel.quantity = D.columns[panel.curves[0].column].quantity
   panel.lines = D.profiles.flatMap((p, k) => panel.curves.filter(c => p.curves[c.column]).map(c => ({
      ...c, name: p.key.text, keys: [k], profile: p, curve: c.limit ? mirrored(p.curves[c.column]) : p.curves[c.column]
   })))
}
for (const chart of D.charts ?? []) {                         // no torque where nothing turns
   const turns = ({curves: [{column}], lines}) => column !== 'torque' || lines.some(l => l.curve.v.some(v => v))
   chart.panels = chart.panels.filter(turns)
}
const meanings = Object.fromEntries(Object.values(D.columns ?? {}).map(c => [c.label, c.meaning]))
for (const line of D.figures.flatMap(f => f.blocks).flatMap(b => b.panels).flatMap(panel => panel.lines)) {
   line.curve = curve_of(line.points)
   if (line.low) { line.low = curve_of(line.low).v; line.high = curve_of(line.high).v }
}
const factor = q => D.quantities[q]?.[units]?.[1] ?? 1, unit = q => D.quantities[q]?.[units]?.[0] ?? q
const row_at = ({d}, depth) => Math.max(0, Math.min(d.findLastIndex(place => place <= depth), d.length - 2))   // at or above it
const rounding = .01                                         // of depths: a load case has 7 digits, a curve three decimals
const reaches = ({d}, depth) => depth >= d[0] - rounding && depth <= d[d.length - 1] + rounding
function value_in(c, depth) {
   if (!c || !reaches(c, depth)) return NaN
   const i = row_at(c, depth), part = (depth - c.d[i]) / (c.d[i + 1] - c.d[i]) || 0
   if (c.words) return c.v[part < .5 ? i : i + 1]
   if (part === 0 || part === 1) return c.v[i + part]        // a value may lack beside it
   if (c.inverse) return 1 / ((1 - part) / c.v[i] + part / c.v[i + 1])
   const step = c.v[i + 1] - c.v[i]                          // of an angle the short way round
   return c.turns ? (c.v[i] + part * ((step + 540) % 360 - 180) + 360) % 360 : c.v[i] + part * step
}
const value_at = (p, name, depth) => value_in(p.curves[name], depth)
const is_held = (p, name, depth) => name === 'gap_state' && p.held && depth >= D.cases[p.case].depth - rounding      // the bit
const word_at = (p, name, depth) => is_held(p, name, depth) ? 'held' : D.columns[name].words[value_at(p, name, depth)] ?? '\u2013'
function text_of(value, q) {
   if (!isFinite(value)) return '\u2013'
   const v = value * factor(q), a = Math.abs(v)
   const text = v.toFixed(a >= 1000 ? +(q === 'length') : a >= 100 ? 1 : a >= 10 ? 2 : 3)
   return +text ? text : text.replace('-', '')               // 0, not -0
}
const depth_of_units = depth => +(depth * factor('length')).toFixed(2)
const over = n => D.columns?.[n]?.over ? `, ${depth_text(D.columns[n].over)}` : ''      // of a force on a length
const depth_text = depth => `${depth_of_units(depth)} ${unit('length')}`

// ---- drawing
function make(parent, tag, attributes, text) {
   const svg = 'http://www.w3.org/2000/svg'
   const e = tag.startsWith('h:') ? document.createElement(tag.slice(2)) : document.createElementNS(svg, tag)
   for (const k in attributes) {
      if (k.startsWith('on')) e.addEventListener(k.slice(2), attributes[k]); else e.setAttribute(k, attributes[k])
   }
   if (text !== undefined) e.textContent = text
   parent?.append(e)
   return e
}
function ticks(low, high, most) {
   const raw = (high - low) / most, power = 10 ** Math.floor(Math.log10(raw))
   const step = power * [1, 2, 5, 10].find(f => f * power >= raw)
   const from = Math.ceil(low / step - 1e-9), to = Math.floor(high / step + 1e-9)
   return Array.from({length: Math.max(0, to - from + 1)}, (_, i) => +((from + i) * step).toPrecision(12))
}
function draw_marks(parent, places, {mark, look: {stroke}}) {
   const d = places.map(place => place + shapes[mark < 4 ? mark - 1 : (mark >> 1) + 1]).join('')
   if (mark) make(parent, 'path', {d, 'stroke-width': 1.6, fill: mark > 4 && mark % 2 ? stroke : 'none', stroke})
}
function draw_key(parent, key) {                             // a piece of a line, or a mark
   const svg = make(parent, 'svg', {viewBox: '0 -4 44 16', class: 'key'})
   if (!key.marks) make(svg, 'line', {x1: 0, x2: 44, y1: 4, y2: 4, 'stroke-width': 3, ...key.look})
   draw_marks(svg, ['M22 4'], key)
}

// ---- a block: panels side by side over one axis, with the legend `keys`. S has `charts` along the string, or `panels`
// over a depth (`over`, `begin`, `end`) or over rows with names (`rows`). Draw it when all are made.
function block(S, address) {
   const state = {case: [choices.case[D.start]], model: choices.model, chart: 0, depth: undefined, hidden: new Set()}
   Object.assign(state, {tint: 'side_force_on_joint', yaw: -0.6, pitch: 0.35})      // of the well
   const depths = () => D.cases.map(c => state.case.includes(c.name) ? c.depth : 0)
   const end_of = () => S.rows ? S.rows.length + .6 : S.end ?? (Math.max(...depths()) || D.cases[D.start].depth)
   const first = state.top = S.rows ? .4 : S.begin ?? 0, view = {}, up = 30, down = 26
   let H                                                        // height of a panel
   const y_of = depth => up + (depth - state.top) / (state.bottom - state.top) * (H - up - down)
   const depth_of = y => state.top + (y - up) / (H - up - down) * (state.bottom - state.top)
   const place_text = () => S.rows ? S.rows[state.depth - 1] : depth_text(state.depth)
   const zoom = (top, bottom) => { Object.assign(state, {top, bottom}); draw() }, whole = () => zoom(first, end_of())
   const first_sheet = () => paper && S.charts[1] && !state.chart      // has this one already
   const panels_of = () => S.panels ?? S.charts[first_sheet() ? 1 : state.chart].panels
   const chosen = p => state.case.includes(D.cases[p.case].name) && state.model.includes(p.model)
   function key_of(p) {                                         // of one load case a colour a model; of several a colour and mark a case
      const cases = [...new Set(D.profiles.filter(chosen).map(({case: c}) => c))], n = cases.indexOf(p.case), most = D.looks.length
      if (cases.length < 2) return p.key
      return {...p.key, mark: D.looks[(n + Math.floor(n / most)) % most].mark, look: {...p.key.look, ...D.looks[n % most].look}}
   }
   const lines_of = panel => S.charts ? panel.lines.filter(l => chosen(l.profile)).map(l => ({...key_of(l.profile), ...l})) : panel.lines
   const visible = line => !line.keys.some(k => state.hidden.has(k))
   const shown = () => D.profiles.filter((p, k) => chosen(p) && !state.hidden.has(k))
   function row_beside({curve: {d, v}}) {                       // of marks the nearest one, if it is near
      const far = i => Math.abs(d[i] - state.depth), near = S.rows ? .5 : 6 / (H - up - down) * (state.bottom - state.top)
      return [...d.keys()].filter(i => isFinite(v[i]) && far(i) <= near).sort((a, b) => far(a) - far(b))[0] ?? -1
   }
   function text_at(line, q) {                                  // its value at the depth that is pointed at
      if (line.edge) return ''
      const i = line.marks ? row_beside(line) : -1, v = line.marks ? line.curve.v[i] : value_in(line.curve, state.depth)
      return text_of(v, q) + (line.low?.[i] === undefined ? '' : ` (${text_of(line.low[i], q)} to ${text_of(line.high[i], q)})`)
   }
   function seen_of(line) {                                     // the points of a curve that are seen, and one more at each end
      const {curve: {d, v}} = line, from = row_at(line.curve, state.top), to = row_at(line.curve, state.bottom) + 2
      return line.marks ? {d, v} : {d: d.subarray(from, to), v: v.subarray(from, to)}
   }
   function path_of({d, v}, x_of, turns) {                      // with a gap where a value lacks, or an angle passes a full turn
      const apart = i => !isFinite(v[i - 1]) || (turns && Math.abs(v[i] - v[i - 1]) > 180)
      const place = i => x_of(v[i]).toFixed(1) + ' ' + y_of(d[i]).toFixed(1)
      return [...d.keys()].filter(i => isFinite(v[i])).map(i => (apart(i) ? `M${place(i)}h0` : 'L' + place(i))).join('')
   }
   function range_of(panel, lines) {                            // of what is seen; along the string 0 is among it
      if (panel.high !== undefined) return [panel.low, panel.high]
      const all = lines.filter(l => !l.loose).flatMap(l => [...l.seen.v, ...(l.low ?? []), ...(l.high ?? [])])
      const known = [...(S.charts ? [0] : []), ...all.filter(v => isFinite(v))]
      const least = known.reduce((a, b) => Math.min(a, b), panel.low ?? known[0] ?? 0)
      const most = known.reduce((a, b) => Math.max(a, b), least), air = Math.max((most - least) * .05, Math.abs(most) * .01) || 1
      return [least === (panel.low ?? 0) ? least : least - air, Math.min(most + air, panel.most ?? Infinity)]
   }
   function draw_axis(svg, left, right, first_of_row) {         // depths, or names of rows
      const length = factor('length'), depths = S.rows ? [] : ticks(state.top * length, state.bottom * length, H / 47)
      if (first_of_row && !S.rows) make(svg, 'text', {x: left - 4, y: 12, 'text-anchor': 'end'}, `MD [${unit('length')}]`)
      for (const [at, name] of S.rows?.map((name, i) => [i + 1, name]) ?? depths.map(t => [t / length, String(t)])) {
         const y = y_of(at), most = Math.floor((left - 6) / 6.4)
         const short = name.length > most ? name.slice(0, most - 1) + '\u2026' : name
         make(svg, 'line', {x1: left, x2: right, y1: y, y2: y, class: 'grid'})
         if (first_of_row) make(make(svg, 'text', {x: left - 4, y: y + 4, 'text-anchor': 'end'}, short), 'title', {}, name)
      }
   }
   function draw_line(clip, marks, line, x) {
      const {look, curve} = line
      if (line.low) {                                           // bars
         const d = [...curve.d].map((d, i) => `M${x(line.low[i])} ${y_of(d)}H${x(line.high[i])}`).join('')
         make(clip, 'path', {d, stroke: look.stroke, 'stroke-width': line.thick ? 14 : 2})
         if (!line.thick) return
      } else if (!line.marks) {
         const d = path_of(line.seen, x, curve.turns)
         make(clip, 'path', {d, fill: 'none', 'stroke-width': 1.7, 'stroke-linecap': 'round', ...look})
      }
      const at = Array.from({length: 8}, (_, i) => state.top + (i + .5) / 8 * (state.bottom - state.top))
      const {d, v} = line.marks ? curve : {d: at, v: at.map(d => value_in(curve, d))}      // on a line for print without colours
      const there = [...d.keys()].filter(i => isFinite(v[i]) && d[i] >= state.top && d[i] <= state.bottom)
      draw_marks(marks, there.map(i => `M${x(v[i]).toFixed(1)} ${y_of(d[i]).toFixed(1)}`), line)
   }
   function draw_panel(panel, index, width) {
      const svg = make(null, 'svg', {viewBox: `0 0 ${width} ${H}`, role: 'img', 'aria-label': panel.label, class: 'panel'})
      const names = S.rows && Math.min(.4 * width, 12 + 6.4 * Math.max(...S.rows.map(n => n.length)))
      const left = index ? 12 : names ?? 46, right = width - 16
      const lines = lines_of(panel).filter(visible).map(l => ({...l, seen: seen_of(l)})), q = panel.quantity, f = factor(q)
      const [low, high] = range_of(panel, lines).map(v => v * f)
      const x_of = v => left + (v * f - low) / (high - low) * (right - left)
      const inside = more => {                                   // a group whose ends are cut off beyond the panel, and so much more
         const place = {x: left - more, y: up - more, width: right - left + 2 * more, height: H - up - down + 2 * more}
         make(make(svg, 'clipPath', {id: 'clip' + ++clips}), 'rect', place)
         return make(svg, 'g', {'clip-path': `url(#clip${clips})`})
      }
      for (const t of panel.ticks ?? ticks(low, high, Math.max(3, (right - left) / 50))) {
         const x = x_of(t / f)
         make(svg, 'line', {x1: x, x2: x, y1: up, y2: H - down, class: t ? 'grid' : 'zero'})
         make(svg, 'text', {x, y: H - down + 15, 'text-anchor': 'middle'}, t)
      }
      draw_axis(svg, left, right, !index)
      make(svg, 'rect', {x: left, y: up, width: right - left, height: H - up - down, class: 'frame'})
      const words = make(make(svg, 'foreignObject', {x: left, y: 0, width: right - left, height: up}), 'h:div', {})
      make(words, 'h:b', {}, panel.label + over(panel.curves?.[0].column) + ' ')
      if (unit(q)) words.append(`[${unit(q)}]`)
      const curves = inside(0), marks = inside(6)                // marks on the frame are whole
      for (const line of lines) draw_line(curves, marks, line, line.edge ? () => left : x_of)
      make(svg, 'line', {x1: left, x2: right, y1: 0, y2: 0, class: 'cross'})
      make(svg, 'rect', {x: left, width: right - left, class: 'band'})
      return svg
   }
   function draw_panels() {
      const panels = panels_of().filter(p => !paper || !S.charts || lines_of(p).some(l => l.curve.v.some(v => v))), bare = !panels.flatMap(lines_of).length
      const none = 'No curves: choose a load case that has a solution. Answers and warnings above say why others have none.'
      S.root.classList.toggle('bare', bare)                     // an empty chart is not drawn
      const wide = paper ? paper.wide / (S.halved ? 2 : 1) : view.panels.clientWidth || 1000
      const abreast = Math.min(panels.length, wide >= 600 ? Infinity : S.rows ? 1 : 2)
      const one = (panel, i) => draw_panel(panel, i % abreast, Math.max(150, wide / abreast))
      view.panels.replaceChildren(...(bare ? [none] : panels.map(one)))
      for (const s of view.panels.children) s.style.width = 100 / abreast + '%'
      set_depth(state.depth)
   }
   function set_depth(depth) {                                  // the slider keeps it within its range, and rows whole
      if (depth !== state.depth) view.notice.textContent = ''
      view.slider.value = depth
      state.depth = +view.slider.value
      if (view.typed) view.typed.value = depth_of_units(state.depth)
      view.panels.style.setProperty('--cross', y_of(state.depth) + 'px')
      view.well?.mark()
      draw_readout()
      note_address()
   }
   function cells_of_profiles() {                               // a row a quantity; of two curves, or two load cases, differences
      const list = shown(), wanted = panels_of().flatMap(p => p.curves.map(c => c.column))
      const known = Object.keys(D.columns).filter(n => list.some(p => p.curves[n]))
      const names = view.all.checked ? known : [...new Set(wanted)]
      const by_model = state.case.length === 2 ? state.model.map(m => list.filter(p => p.model === m)) : []
      const pairs = list.length === 2 ? [list] : by_model.filter(pair => pair.length === 2)
      const heads = pairs.map(([a, b]) => `${b.key.text} less ${a.key.text}`)
      const above = p => D.cases[p.case].depth - state.depth
      const there = p => D.cases[p.case].parts.find(({from, to}) => from <= above(p) && above(p) <= to)
      const row_of = n => {
         const {label, quantity, words, inverse} = D.columns[n], at = p => value_at(p, n, state.depth)
         const band = p => (p.bands?.[n] ?? 0) * (inverse ? at(p) ** 2 : 1) * factor(quantity)      // within which a value is known
         const told = (value, b) => text_of(value, quantity) + (b > 0 ? ` \u00b1${+b.toPrecision(2)}` : '')
         return [label + over(n), unit(quantity), ...list.map(p => words ? word_at(p, n, state.depth) : told(at(p), band(p))),
            ...pairs.map(([a, b]) => words ? '' : told(at(b) - at(a), band(a) + band(b)))]
      }
      return [
         ['quantity', 'unit', ...list.map(p => p.key.text), ...heads],
         ['component', '', ...list.map(p => there(p)?.name ?? '\u2013'), ...pairs.map(() => '')],
         ...names.map(row_of)
      ]
   }
   function cells_of_lines() {                                  // a row a line that reaches the depth, or mark near it
      const panels = panels_of(), lines = panels.map(p => lines_of(p).filter(visible))
      const near = lines.flat().filter(l => l.marks ? row_beside(l) >= 0 : reaches(l.curve, state.depth))
      const heads = panels.map(p => p.label + (unit(p.quantity) ? ` [${unit(p.quantity)}]` : ''))
      const texts = (name, k) => lines[k].filter(l => l.name === name).map(l => text_at(l, panels[k].quantity))
      const within = (few, many) => few.length === many.length - 1 && few.every(k => many.includes(k))
      const under = mark => lines.flat().find(l => mark.marks && !l.marks && within(l.keys, mark.keys))    // the line that it is on
      const bases = new Map(near.filter(under).map(mark => [mark.name, under(mark).name]))      // one row for both
      const names = [...new Set(near.map(l => l.name))].filter(name => ![...bases.values()].includes(name))
      const text_of_name = (name, k) => texts(bases.get(name) ?? name, k).find(text => text !== '\u2013') ?? '\u2013'
      return [['curve', ...heads], ...names.map(name => [name, ...panels.map((_, k) => text_of_name(name, k))])]
   }
   function draw_readout() {                                    // a table; a screen reader has its words from the slider
      const table = make(null, 'h:table', {}), rows = S.charts ? cells_of_profiles() : cells_of_lines()
      make(table, 'h:caption', {}, S.rows ? place_text() : `At ${place_text()} ${S.over}`)
      rows.forEach((row, k) => {
         const line = make(table, 'h:tr', {})
         row.forEach((text, i) => make(line, k ? 'h:td' : 'h:th', {class: i ? '' : 'text', title: meanings[text.split(', ')[0]] ?? ''}, text))
      })
      view.readout.replaceChildren(table)
      view.slider.setAttribute('aria-valuetext', [place_text(), ...rows.map(row => row.join(' '))].join(', '))
   }
   function draw() {
      H = S.rows ? 64 + (paper ? 15 : 24) * S.rows.length : paper?.high ?? 420
      if (!(state.bottom > state.top) || state.bottom > end_of()) Object.assign(state, {top: first, bottom: end_of()})
      Object.assign(view.slider, S.rows ? {min: 1, max: S.rows.length} : {min: state.top, max: state.bottom})
      if (view.typed) view.typed.previousSibling.textContent = `${S.over} [${unit('length')}] `
      draw_legend()
      draw_panels()
      view.well?.draw()
   }
   function add_list(parent, key, text) {                       // of which several may be chosen
      const more = {multiple: '', size: Math.min(1 + choices[key].length, 16)}
      const list = make(make(parent, 'h:label', {}, text), 'h:select', more)
      for (const name of choices[key]) make(list, 'h:option', {}, name).selected = state[key].includes(name)
      list.onchange = () => { state[key] = [...list.selectedOptions].map(o => o.value); draw() }
   }
   function draw_legend() {                                     // an entry in white is words alone; one without a line is left out
      const used = new Set(panels_of().flatMap(lines_of).flatMap(l => l.keys))
      view.legend.replaceChildren()
      S.keys.forEach((key, id) => {
         if (key.words) make(view.legend, 'h:span', {}, key.text)
         if (key.words || !used.has(id)) return
         const turn = () => { if (!state.hidden.delete(id)) state.hidden.add(id); draw() }
         const b = make(view.legend, 'h:button', {type: 'button', 'aria-pressed': !state.hidden.has(id), onclick: turn})
         draw_key(b, S.charts ? key_of(D.profiles[id]) : key)
         b.append(key.text)
      })
   }
   function go_to(depth) {                                      // also beyond what is zoomed to; the old one if it is no number
      if (depth < state.top || depth > state.bottom) whole()
      set_depth(isNaN(depth) ? state.depth : depth)
   }
   function listen() {                                           // a mouse is dragged over what to zoom to, two fingers spread it
      let from, pinch, wanted
      const y_in = ({target, clientY}) => {
         const place = target.closest('svg.panel')?.getBoundingClientRect()
         return place ? (clientY - place.top) / place.height * H : NaN
      }
      const want = (top, bottom) => {                           // shown as a band
         wanted = [Math.max(first, top), Math.min(end_of(), bottom)]
         view.panels.style.setProperty('--band', y_of(wanted[0]) + 'px')
         view.panels.style.setProperty('--bands', Math.max(0, y_of(wanted[1]) - y_of(wanted[0])) + 'px')
      }
      const point = e => {
         const y = y_in(e)
         if (isNaN(y)) return
         if (e.type === 'pointerdown' && e.pointerType === 'mouse' && !S.rows) from = y
         set_depth(depth_of(y))
         if (Math.abs(y - from) > 6) want(depth_of(Math.min(from, y)), depth_of(Math.max(from, y)))
      }
      const spread = e => {
         if (e.touches.length !== 2 || S.rows) return
         e.preventDefault()
         const [a, b] = [...e.touches].map(y_in).sort((a, b) => a - b)
         pinch ??= [depth_of(a), depth_of(b)]
         const step = (pinch[1] - pinch[0]) / Math.max(b - a, 20), top = Math.max(0, pinch[0] - step * (a - up))
         want(top, top + step * (H - up - down))
      }
      const finish = () => {
         if (wanted?.[1] > wanted?.[0]) zoom(...wanted)
         view.panels.style.removeProperty('--bands')
         from = pinch = wanted = undefined
      }
      for (const kind of ['pointerdown', 'pointermove']) view.panels.addEventListener(kind, point)
      for (const kind of ['touchstart', 'touchmove']) view.panels.addEventListener(kind, spread, {passive: false})
      for (const kind of ['pointerup', 'touchend']) addEventListener(kind, finish)
   }
   function note_address() {                                     // after a pause: the view is a link
      if (active !== S) return
      clearTimeout(noting)
      noting = setTimeout(() => {
         const q = new URLSearchParams(S.charts ? state.case.map(name => ['case', name]) : [])
         if (S.charts && state.model.length < choices.model.length) for (const name of state.model) q.append('model', name)
         q.set('chart', S.title ?? S.charts[state.chart].title)
         const zoomed = state.top > first || state.bottom < end_of()
         for (const k of zoomed ? ['depth', 'top', 'bottom'] : ['depth']) q.set(k, +state[k].toFixed(3))
         if (units !== D.units) q.set('units', units)
         history.replaceState(null, '', '#' + q)
      }, 300)
   }
   // #case=NAME&case=NAME&model=NAME&chart=TITLE&depth=M&top=M&bottom=M&units=field
   for (const k of ['case', 'model']) if (address.has(k)) state[k] = address.getAll(k)
   state.chart = Math.max(0, S.charts?.findIndex(c => c.title === address.get('chart')) ?? 0)
   for (const k of ['depth', 'top', 'bottom']) if (isFinite(parseFloat(address.get(k)))) state[k] = parseFloat(address.get(k))
   S.root.replaceChildren()
   const bar = make(S.root, 'h:div', {class: 'bar'})
   const button = (text, onclick, more) => make(bar, 'h:button', {type: 'button', onclick, ...more}, text)
   const choose = i => {
      state.chart = i
      bar.querySelectorAll('.tab').forEach((o, k) => o.setAttribute('aria-pressed', k === i))
      draw()
   }
   S.charts?.forEach((c, i) => button(c.title, () => choose(i), {'aria-pressed': i === state.chart, class: 'tab'}))
   add_switch(bar)
   if (!S.rows) button('whole depth', whole)
   if (S.charts) button(lowest(), () => zoom(Math.max(0, end_of() - shown_length), end_of()))
   const main = make(S.root, 'h:div', {class: S.charts ? 'main' : 'alone'})
   if (S.charts) {
      const side = make(main, 'h:div', {class: 'side'})
      add_list(side, 'case', 'Load cases, several with Ctrl')
      if (choices.model.length > 1) add_list(side, 'model', 'Models')
   }
   const right = make(main, 'h:div', {class: 'right'})
   view.notice = make(right, 'h:p', {class: 'notice'})              // what is wrong with the address
   view.legend = make(right, 'h:div', {class: 'legend'})
   view.panels = make(right, 'h:div', {class: 'panels'})
   const slide = {'aria-label': S.over ?? 'row', oninput: e => set_depth(+e.target.value)}
   view.slider = make(right, 'h:input', {type: 'range', step: S.rows ? 1 : 'any', ...slide})
   if (!S.rows) {
      const type = {type: 'number', step: 'any', min: 0, onchange: e => go_to(e.target.valueAsNumber / factor('length'))}
      view.typed = make(make(right, 'h:label', {class: 'typed'}, ' '), 'h:input', type)
   }
   view.readout = make(right, 'h:div', {class: 'wide readout', tabindex: 0})
   if (S.charts) {
      const label = make(right, 'h:label', {})
      view.all = make(label, 'h:input', {type: 'checkbox', onchange: draw_readout})
      label.append(' all columns')
      view.well = well_figures({root: S.root, state, shown, key_of, place_text, set_depth})
   }
   listen()
   view.panels.addEventListener('dblclick', whole)
   for (const kind of ['pointerenter', 'focusin']) S.root.addEventListener(kind, () => active = S)
   state.bottom ??= end_of()
   const known = ({curve: {d, v}}) => [...d].filter((_, i) => isFinite(v[i]))           // rows with a number
   const first_row = () => Math.round(Math.min(...S.panels.flatMap(p => p.lines).filter(l => l.marks).flatMap(known)))
   state.depth ??= S.rows ? first_row() : S.end ?? state.bottom / 2
   const unknown = (k, what) => state[k].filter(name => !choices[k].includes(name)).map(name => `No ${what} is named '${name}'.`)
   const names = S.charts ? [...unknown('case', 'load case'), ...unknown('model', 'model')] : []
   const deep = !S.rows && state.depth > end_of() + rounding ? [`The address asks for ${depth_text(state.depth)}. The chart ends at ${depth_text(end_of())}.`] : []
   view.notice.textContent = [...names, ...deep].join(' ')
   return {S, state, draw}
}

// ---- the page
function add_switch(parent) {
   const turn = () => { units = D.systems[(D.systems.indexOf(units) + 1) % D.systems.length]; draw_all() }
   make(parent, 'h:button', {type: 'button', class: 'units', onclick: turn})
}
function draw_all() {
   for (const b of blocks) b.draw()
   for (const head of document.querySelectorAll('th[data-q]')) {       // columns of tables whose numbers have a unit
      const {q, digits} = head.dataset
      head.querySelector('small').textContent = unit(q)
      for (const {cells: {[head.cellIndex]: cell}} of head.closest('table').tBodies[0].rows) {
         const own = cell.dataset.own ??= cell.textContent, value = (cell.dataset.v ?? own) * factor(q)
         const text = digits ? String(+value.toPrecision(digits)) : value.toFixed(own.split('.')[1]?.length ?? 0)
         cell.textContent = units === D.units || own === '' || isNaN(value) ? own : text
      }
   }
   for (const e of document.querySelectorAll('[data-si],[data-field],[data-metric]')) {
      const own = e.dataset.own ??= e.textContent               // a sentence, which has its words in other systems
      e.textContent = e.dataset[units.toLowerCase()] ?? own
   }
   document.querySelector('.switched').hidden = units === D.units
   for (const b of document.querySelectorAll('.units')) b.textContent = 'units: ' + units
}
function follow_address() {                                   // the block that the address means is made anew
   const q = new URLSearchParams(location.hash.slice(1))
   if (D.systems.includes(q.get('units'))) units = q.get('units')
   active = parts.find(S => S.title && S.title === q.get('chart')) ?? parts[0]
   parts.forEach((S, i) => { if (S === active || !blocks[i]) blocks[i] = block(S, S === active ? q : new URLSearchParams()) })
   draw_all()
   if (q.size) active.root.scrollIntoView()
}
addEventListener('hashchange', follow_address)
addEventListener('resize', draw_all)
const draw_for = size => { paper = size; draw_all() }
function write_depths(p) {                                    // for paper: values along a profile, a dozen depths
   const place = document.querySelector('.depths'), f = factor('length'), end = D.cases[p.case].depth
   const known = ['axial', 'torque', 'side_force_on_joint', 'bending', 'displacement', 'von_mises', 'safety_factor', 'buckling_margin']
   const names = known.filter(n => p.curves[n]?.v.some(v => v)), quantity = n => D.columns[n].quantity
   const heads = ['measured depth', ...names.map(n => D.columns[n].label + over(n))]
   const units_of = [unit('length'), ...names.map(n => unit(quantity(n)))]
   place.replaceChildren()
   make(place, 'h:h2', {}, 'Along the string: ' + p.key.text)
   const table = make(place, 'h:table', {}), head = make(make(table, 'h:thead', {}), 'h:tr', {}), body = make(table, 'h:tbody', {})
   heads.forEach((text, i) => make(head, 'h:th', {}, text + (units_of[i] ? ` [${units_of[i]}]` : '')))
   for (const depth of [...ticks(0, end * f, 18).map(t => t / f).filter(d => d < end), end]) {
      const row = make(body, 'h:tr', {}), texts = names.map(n => text_of(value_at(p, n, depth), quantity(n)))
      for (const text of [depth_of_units(depth), ...texts]) make(row, 'h:td', {}, text)
   }
}
const folded = []                                             // parts of the page that paper alone opens
addEventListener('afterprint', () => {
   for (const part of folded.splice(0)) part.open = false
   draw_for(null)
})
addEventListener('beforeprint', () => {                       // the first sheet has the load cases that are chosen, if one has curves
   if (D.profiles) {
      paper = {wide: 660, high: 300}
      const root = make(null, 'h:div', {}), charts = [{panels: D.charts[0].panels.slice(0, 4)}], {state} = blocks[0]
      const solved = D.profiles.some(p => state.case.includes(D.cases[p.case].name) && state.model.includes(p.model))
      const view = ['case', 'model'].flatMap(k => state[k].map(name => [k, name]))
      block({root, keys: D.profiles.map(p => p.key), charts}, new URLSearchParams(solved ? view : [])).draw()
      document.querySelector('.first').replaceChildren(...root.querySelectorAll('.legend, .panels'))
      const chosen = p => state.case.includes(D.cases[p.case].name) && state.model.includes(p.model)
      write_depths(D.profiles.find(chosen) ?? D.profiles.find(p => p.case === D.start))
   }
   for (const part of document.querySelectorAll('.on-paper:not([open])')) {
      folded.push(part)
      part.open = true
   }
   draw_for({wide: 1100, high: 260})
})
const places = [...document.querySelectorAll('.live:not(.first)')]
const root_in = place => make(place, 'h:div', {})
const string = () => ({charts: D.charts, keys: D.profiles.map(p => p.key), over: 'measured depth', root: root_in(places.shift())})
const along = D.profiles ? [string()] : []
const title_of = (f, i) => f.title + (i ? ` (${i + 1})` : '')
const of_figure = (f, place) => f.blocks.map((b, i) => ({
   ...b, keys: f.keys, title: title_of(f, i), root: root_in(place), halved: f.blocks.length > 1      // on paper in two columns
}))
const parts = [...along, ...D.figures.flatMap((f, i) => of_figure(f, places[i]))]
document.querySelector('.hint').append(` Curves are thinned to ${D.thinned} of their range, safety factors by their inverse.${D.reduced} The CSV files have all points.`)
add_switch(document.querySelector('h1 + p'))
follow_address()
document.documentElement.classList.add('scripted')            // last: where a script fails fixed pictures stand
if (location.hash) active.root.scrollIntoView()               // without them it stands higher
