// Interactive part of a report: no library, nothing fetched. All that is shown stands in the page's data (id="data"):
// D.columns, D.quantities, D.profiles (thinned curves), D.charts (which curve stands in which panel), D.figures (pictures of the
// run: blocks of panels with their own curves). Numbers are in D.units.
'use strict'
const D = JSON.parse(document.getElementById('data').textContent)
const NS = 'http://www.w3.org/2000/svg'
const colours = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', '#56B4E9', '#E69F00', '#7f6fd0', '#999999']
const dashes = ['', '8 4', '2 3', '8 3 2 3']
const shapes = ['m0-5v10m-5-5h10', 'm-4-4l8 8m0-8l-8 8', 'm0-5v10m-4.3-7.5l8.6 5m0-5l-8.6 5', 'm-4-4h8v8h-8z', 'm-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z',
   'm0-5l5 8.5h-10z', 'm0 5l5-8.5h-10z', 'm0-5.5l4.5 5.5l-4.5 5.5l-4.5-5.5z', 'm0-5l4.8 3.5l-1.8 5.5h-6l-1.8-5.5z']   // gnuplot's marks
const blocks = []                                            // all charts of the page that answer
const shown_length = 40 / D.quantities.length.SI[1]          // of the assembly in its hole
let units = D.systems.includes(D.units) ? D.units : D.systems[0], clips = 0, noting = 0, active = null

// ---- data
function curve_of(text) {                                    // "step value step value ..." in thousandths of D.units' length
   const t = text === '' ? [] : text.split(' '), n = t.length / 2, d = new Float64Array(n), v = new Float64Array(n)
   for (let i = 0, sum = 0; i < n; i++) { d[i] = (sum += +t[2 * i]) / 1000; v[i] = t[2 * i + 1] === '' ? NaN : +t[2 * i + 1] }
   return {d, v}
}
for (const p of D.profiles ?? []) for (const name in p.curves)
   p.curves[name] = typeof p.curves[name] === 'number' ? D.profiles[p.curves[name]].curves[name] : curve_of(p.curves[name])   // a number: the same as an earlier one
const look_in = c => ({stroke: c.stroke ?? 'none', 'stroke-dasharray': c.dash ?? ''})
for (const f of D.figures) for (const b of f.blocks) for (const panel of b.panels) for (const line of panel.lines) {
   line.name ||= line.keys.map(k => f.keys[k].text).join(', ')
   if (!line.keys.length) {                                  // an entry of its own
      const i = f.keys.findIndex(k => k.text === line.name)
      line.keys = [i < 0 ? f.keys.push({...line, text: line.name}) - 1 : i]
   }
   line.look = look_in(line)
   line.quantity = panel.quantity
   line.curve = curve_of(line.points)
   if (line.low) { line.low = curve_of(line.low).v; line.high = curve_of(line.high).v }
}
const column = name => D.columns[name]
const factor = q => D.quantities[q]?.[units]?.[1] ?? 1, unit = q => D.quantities[q]?.[units]?.[0] ?? q
function row_at(c, depth) {                                  // last row at or above a depth
   let low = 0, high = c.d.length - 1
   while (high - low > 1) { const m = (low + high) >> 1; if (c.d[m] <= depth) low = m; else high = m }
   return low
}
function value_in(c, depth, words, turns) {
   if (!c || !(depth >= c.d[0] && depth <= c.d[c.d.length - 1])) return NaN
   const i = row_at(c, depth), step = c.d[i + 1] - c.d[i]
   if (words) return c.v[depth - c.d[i] < c.d[i + 1] - depth ? i : i + 1]
   if (depth === c.d[i] || depth === c.d[i + 1]) return c.v[depth === c.d[i] ? i : i + 1]   // a value may lack beside it
   let turn = c.v[i + 1] - c.v[i]
   if (turns) turn = ((turn + 540) % 360) - 180              // the short way round
   const v = c.v[i] + (step > 0 ? (depth - c.d[i]) / step * turn : 0)
   return turns ? (v + 360) % 360 : v
}
const value_at = (p, name, depth) => value_in(p.curves[name], depth, column(name).words, name === 'clock')
function text_of(value, q) {
   if (!isFinite(value)) return '\u2013'
   const v = value * factor(q), a = Math.abs(v)
   return v.toFixed(a >= 1000 ? 0 : a >= 100 ? 1 : a >= 10 ? 2 : 3)
}
const depth_text = depth => text_of(depth, 'length') + ' ' + unit('length')
const round_text = depth => text_of(depth, 'length').replace(/\.0+$/, '') + ' ' + unit('length')

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
function colour(t) {                                         // dark blue, green, yellow, red
   const stops = [[70, 100, 215], [20, 145, 140], [120, 190, 70], [245, 215, 60], [210, 50, 30]], x = Math.min(Math.max(t, 0), 1) * 4, i = Math.min(3, Math.floor(x))
   return 'rgb(' + stops[i].map((a, k) => Math.round(a + (stops[i + 1][k] - a) * (x - i))).join() + ')'
}
function marks_path(curve, x_of, y_of, [from, to], shape) {  // marks that would hide each other are one
   let path = '', last = ''
   for (let i = from; i < to; i++) if (isFinite(curve.v[i])) {
      const at = x_of(curve.v[i]).toFixed(0) + ' ' + y_of(curve.d[i]).toFixed(0)
      if (at !== last) path += 'M' + at + shape
      last = at
   }
   return path
}
const shape_of = mark => shapes[mark < 4 ? mark - 1 : (mark >> 1) + 1], filled = (mark, ink) => (mark > 4 && mark % 2 ? ink : 'none')
function draw_key(parent, {mark, marks}, look) {             // a piece of a line, or a mark
   const svg = make(parent, 'svg', {viewBox: '0 -4 28 16', class: 'key'})
   if (!marks) make(svg, 'line', {x1: 0, x2: 28, y1: 4, y2: 4, 'stroke-width': 3, ...look})
   if (mark) make(svg, 'path', {d: 'M14 4' + shape_of(mark), fill: filled(mark, look.stroke), stroke: look.stroke, 'stroke-width': 1.6})
}

// ---- a block: panels side by side over one axis. S has `profiles` and `charts` along the string, or panels with their own lines,
// over a depth (`over`, `end`) or over rows with names (`rows`).
function block(root, S) {
   const end_of = () => S.rows ? S.rows.length + .6 : S.end ?? Math.max(...(state.cases.length ? state.cases : [D.start]).map(i => D.cases[i].depth))
   const first = S.rows ? .4 : 0
   const state = {cases: [D.start], models: [0, 1].filter(i => i < (D.models ?? []).length), chart: 0, top: first, bottom: 0, depth: undefined,
      tint: 'side_force_on_joint', yaw: -0.6, pitch: 0.35, near: 1, hidden: new Set()}
   const view = {}, H = S.rows ? 64 + 24 * S.rows.length : 420, up = 30, down = 26
   const shown = () => (S.profiles ?? []).filter(p => state.cases.includes(p.case) && state.models.includes(p.model))
   const look_of = p => ({stroke: colours[(state.cases.length > 1 ? state.cases.indexOf(p.case) : p.model) % 8], 'stroke-dasharray': dashes[p.model]})
   const name_of = p => D.cases[p.case].name + ' ' + D.models[p.model]
   const visible = line => !line.keys.some(k => state.hidden.has(k))
   const y_of = depth => up + (depth - state.top) / (state.bottom - state.top) * (H - up - down)
   const depth_of = y => state.top + (y - up) / (H - up - down) * (state.bottom - state.top)
   const place_text = () => S.rows ? S.rows[state.depth - 1] : depth_text(state.depth)
   const panels_of = () => S.panels ?? S.charts[state.chart].panels
   function lines_of(panel) {                                   // its own, or those of the profiles that are shown
      if (panel.lines) return panel.lines
      const list = []
      for (const p of shown()) for (const c of panel.curves) if (p.curves[c.column] && (!c.limit || p === shown()[0]))
         list.push({
            name: name_of(p), keys: [name_of(p)], quantity: column(c.column).quantity,
            curve: p.curves[c.column], sign: c.sign ?? 1, turns: c.column === 'clock', limit: c.limit,
            look: c.limit ? {stroke: 'currentColor', 'stroke-dasharray': '2 3', 'stroke-width': 1} : look_of(p)
         })
      return list
   }
   function row_beside(line, depth) {                           // of marks the nearest one, if it is near
      let least = S.rows ? .5 : 6 / (H - up - down) * (state.bottom - state.top), best = -1
      line.curve.d.forEach((d, i) => { if (Math.abs(d - depth) <= least && isFinite(line.curve.v[i])) { least = Math.abs(d - depth); best = i } })
      return best
   }
   function value_of(line, depth) {
      if (line.marks) return line.curve.v[row_beside(line, depth)] ?? NaN
      return (line.sign ?? 1) * value_in(line.curve, depth, false, line.turns)
   }
   function told_of(line) {
      const text = text_of(value_of(line, state.depth), line.quantity), i = line.low ? row_beside(line, state.depth) : -1
      return i < 0 ? text : `${text} (${text_of(line.low[i], line.quantity)} to ${text_of(line.high[i], line.quantity)})`
   }
   // A line of no more than four points a pixel of depth: first, least, greatest and last (to and fro within a pixel is a bar).
   function path_of(curve, [from, to], x_of, turns) {
      let path = '', gap = true, at = NaN, few = []
      const flush = () => {
         if (few.length > 4) {
            const x = few.map(a => a[0]), least = x.indexOf(Math.min(...x)), most = x.indexOf(Math.max(...x))
            few = [...new Set([0, least, most, few.length - 1])].sort((a, b) => a - b).map(i => few[i])
         }
         for (const [x, y] of few) { path += (gap ? 'M' : 'L') + x.toFixed(1) + ' ' + y.toFixed(1) + (gap ? 'h0' : ''); gap = false }
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
   function range_of(panel, lists, rows) {                      // of what is seen; along the string 0 is among it
      let low = panel.low ?? (S.profiles ? 0 : Infinity), high = panel.high ?? (S.profiles ? 0 : -Infinity)
      const take = v => { if (isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v) } }
      if (panel.high === undefined) {
         lists.forEach((l, k) => {
            if (l.limit || !visible(l)) return
            for (let i = rows[k][0]; i < rows[k][1]; i++) {
               take((l.sign ?? 1) * l.curve.v[i])
               if (l.low) { take(l.low[i]); take(l.high[i]) }
            }
         })
         if (!(low < high)) { const middle = isFinite(low) ? low : 0; low = middle - 1; high = middle + 1 }
         const air = (high - low) * .05
         if (low !== (panel.low ?? 0)) low -= air
         high += air
      }
      return [low, Math.min(high, panel.most ?? Infinity)]
   }
   function rows_of({curve, marks}) {                           // of its points those that can be seen: from, and before
      const all = curve.d.length
      return marks ? [0, all] : [row_at(curve, state.top), Math.min(all, row_at(curve, state.bottom) + 2)]
   }
   function draw_axes(svg, left, right, index) {                // depths, or names of rows
      const level = (at, text) => {
         const y = y_of(at), most = Math.floor((left - 6) / 6.4), name = String(text), long = name.length > most
         make(svg, 'line', {x1: left, x2: right, y1: y, y2: y, class: 'grid'})
         if (index) return
         const short = long ? name.slice(0, most - 1) + '\u2026' : name
         const label = make(svg, 'text', {x: left - 4, y: y + 4, 'text-anchor': 'end'}, short)
         if (long) make(label, 'title', {}, name)
      }
      const length = factor('length')
      if (S.rows) S.rows.forEach((name, i) => level(i + 1, name))
      else for (const t of ticks(state.top * length, state.bottom * length, 9)) level(t / length, t)
   }
   function draw_label(svg, label, brackets, left, right) {     // a long one goes on beside its unit
      const most = Math.floor((right - left) / 6.7), end = label.length > most ? label.lastIndexOf(' ', most) : label.length
      make(svg, 'text', {x: left, y: 12, class: 'label'}, label.slice(0, end))
      const second = make(svg, 'text', {x: left, y: 25}, '')
      make(second, 'tspan', {class: 'label'}, label.slice(end + 1))
      second.append(' ' + brackets)
   }
   function draw_line(clip, line, rows, x_of) {
      const {look, mark, curve} = line, x = v => x_of((line.sign ?? 1) * v), ink = look.stroke
      const put_marks = (curve, rows) => {
         const d = marks_path(curve, x, y_of, rows, shape_of(mark))
         make(clip, 'path', {d, 'stroke-width': 1.5, fill: filled(mark, ink), stroke: ink})
      }
      if (line.low) {                                           // bars, with a mark in thick ones
         curve.d.forEach((d, i) => {
            const ends = {x1: x(line.low[i]), x2: x(line.high[i]), y1: y_of(d), y2: y_of(d)}
            make(clip, 'line', {...ends, stroke: ink, 'stroke-width': line.thick ? 14 : 2})
         })
         if (line.thick) put_marks(curve, rows)
      } else if (line.marks) {
         put_marks(curve, rows)
      } else {
         const d = path_of(curve, rows, x, line.turns)
         make(clip, 'path', {d, fill: 'none', 'stroke-width': 1.7, 'stroke-linecap': 'round', ...look})
         if (!mark) return
         // here and there, for print without colours
         const at = Array.from({length: 8}, (_, i) => state.top + (i + .5) / 8 * (state.bottom - state.top))
         put_marks({d: at, v: at.map(d => value_in(curve, d))}, [0, at.length])
      }
   }
   function draw_panel(panel, index, width) {
      const svg = make(null, 'svg', {viewBox: `0 0 ${width} ${H}`, role: 'img', 'aria-label': panel.label, class: 'panel'})
      const longest = S.rows ? Math.max(...S.rows.map(n => n.length)) : 0
      const left = index ? 12 : S.rows ? Math.min(.4 * width, 12 + 6.4 * longest) : 46, right = width - 10
      const lists = lines_of(panel), rows = lists.map(rows_of), q = panel.quantity ?? column(panel.curves[0].column).quantity, f = factor(q)
      const [low, high] = range_of(panel, lists, rows).map(v => v * f)
      const x_of = v => left + (v * f - low) / (high - low) * (right - left)
      make(make(svg, 'clipPath', {id: 'clip' + ++clips}), 'rect', {x: left, y: up, width: right - left, height: H - up - down})
      for (const t of panel.ticks ?? ticks(low, high, Math.max(3, (right - left) / 50))) {
         const x = left + (t - low) / (high - low) * (right - left)
         make(svg, 'line', {x1: x, x2: x, y1: up, y2: H - down, class: t ? 'grid' : 'zero'})
         make(svg, 'text', {x, y: H - down + 15, 'text-anchor': 'middle'}, t)
      }
      draw_axes(svg, left, right, index)
      make(svg, 'rect', {x: left, y: up, width: right - left, height: H - up - down, class: 'frame'})
      draw_label(svg, panel.label, unit(q) && `[${unit(q)}]`, left, right)
      const clip = make(svg, 'g', {'clip-path': `url(#clip${clips})`})
      lists.forEach((line, k) => { if (visible(line)) draw_line(clip, line, rows[k], x_of) })
      const cross = make(svg, 'g', {class: 'cross'})
      svg.cross = () => {
         cross.replaceChildren()
         if (state.depth < state.top || state.depth > state.bottom) return
         const y = y_of(state.depth), seen = lists.filter(l => visible(l) && !l.limit && isFinite(value_of(l, state.depth)))
         make(cross, 'line', {x1: left, x2: right, y1: y, y2: y})
         if (S.rows) return
         seen.forEach((line, k) => {
            const v = value_of(line, state.depth), x = x_of(v), ink = line.look.stroke
            if (x >= left && x <= right) make(cross, 'circle', {cx: x, cy: y, r: 3.5, fill: ink})
            if (seen.length < 7) make(cross, 'text', {x: right - 3, y: (y < 100 ? y + 14 : y - 5) + (y < 100 ? 1 : -1) * 13 * k, 'text-anchor': 'end', style: 'fill:' + ink, class: 'value'}, text_of(v, q))
         })
         if (!index) make(cross, 'text', {x: left + 3, y: y < 100 ? y + 14 : y - 5, class: 'value'}, place_text())
      }
      return svg
   }
   function draw_panels() {
      const panels = panels_of(), bare = S.profiles !== undefined && !shown().length
      root.classList.toggle('bare', bare)                       // an empty chart is not drawn
      if (bare) {
         const names = state.cases.map(i => D.cases[i].name).join(', ')
         view.panels.replaceChildren(make(null, 'h:p', {class: 'note'}, state.cases.length * state.models.length
            ? `No curves: no solution of ${names}. Answers and warnings above say why.` : 'No curves: choose a load case and a model.'))
         return
      }
      const wide = view.panels.clientWidth || 1000, abreast = Math.min(panels.length, wide >= 600 ? Infinity : S.rows ? 1 : 2)
      view.panels.replaceChildren(...panels.map((p, i) => draw_panel(p, i % abreast, Math.max(150, wide / abreast))))
      for (const s of view.panels.children) s.style.width = 100 / abreast + '%'
      draw_cross()
   }
   const reach = () => S.rows ? [1, S.rows.length] : [state.top, state.bottom]
   function set_depth(depth) {
      const [low, high] = reach()
      state.depth = Math.min(Math.max(S.rows ? Math.round(depth) : depth, low), high)
      draw_cross()
   }
   let waiting = false
   function draw_cross() {
      if (waiting) return
      waiting = true
      requestAnimationFrame(() => {
         waiting = false
         for (const s of view.panels.children) s.cross()
         const [min, max] = reach()
         Object.assign(view.slider, {min, max, value: state.depth})
         view.slider.setAttribute('aria-valuetext', told())
         view.well?.mark()
         draw_readout()
         note_address()
      })
   }
   function told() {                                            // what a screen reader says
      return place_text() + ', ' + panels_of().map(a => a.label + ' ' + lines_of(a).filter(l => visible(l) && isFinite(value_of(l, state.depth)))
         .map(l => l.name + ' ' + told_of(l)).join(', ')).join('; ')
   }
   function cells_of_profiles() {                               // a row a quantity
      const list = shown().filter(p => !state.hidden.has(name_of(p))), wanted = panels_of().flatMap(p => p.curves.map(c => c.column))
      const names = view.all.checked ? Object.keys(D.columns) : [...new Set(wanted)], both = list.length === 2
      return [['quantity', 'unit', ...list.map(name_of), ...(both ? ['difference'] : [])], ...names.map(n => {
         const c = column(n), v = list.map(p => value_at(p, n, state.depth))
         return [[c.label, c.meaning], unit(c.quantity), ...v.map(x => c.words ? c.words[x] ?? '\u2013' : text_of(x, c.quantity)), ...(both ? [c.words ? '' : text_of(v[1] - v[0], c.quantity)] : [])]
      })]
   }
   const reaches = ({curve: {d}}) => state.depth >= d[0] && state.depth <= d[d.length - 1]
   function cells_of_lines() {                                  // a row a line: all that reach the depth, of marks those that are near
      const panels = panels_of(), lines = panels.map(p => lines_of(p).filter(visible))
      const told = lines.flat().filter(l => l.marks ? isFinite(value_of(l, state.depth)) : reaches(l))
      const heads = panels.map(p => p.label + (unit(p.quantity) ? ` [${unit(p.quantity)}]` : ''))
      const cell = (name, list) => list.filter(l => l.name === name).map(told_of).find(text => text !== '\u2013') ?? '\u2013'
      return [['curve', ...heads], ...[...new Set(told.map(l => l.name))].map(name => [name, ...lines.map(list => cell(name, list))])]
   }
   function draw_readout() {
      const table = make(null, 'h:table', {}), [head, ...rows] = S.profiles ? cells_of_profiles() : cells_of_lines()
      make(table, 'h:caption', {}, 'At ' + place_text() + (S.rows ? '' : ' ' + S.over))
      const heads = make(make(table, 'h:thead', {}), 'h:tr', {}), body = make(table, 'h:tbody', {})
      head.forEach((t, i) => make(heads, 'h:th', {scope: 'col', ...(i ? {} : {class: 'text'})}, t))
      for (const row of rows) {
         const line = make(body, 'h:tr', {})
         row.forEach((t, i) => {
            const [text, title] = [t].flat()
            make(line, 'h:td', {...(i ? {} : {class: 'text'}), ...(title ? {title} : {})}, text)
         })
      }
      view.readout.replaceChildren(table)
   }

   // ---- the page
   function draw() {
      const end = end_of()
      if (!(state.bottom > state.top) || state.bottom > end) { state.top = first; state.bottom = end }
      state.depth = Math.min(state.depth, state.bottom)
      view.units.textContent = 'units: ' + units
      draw_legend()
      draw_panels()
      view.well?.draw()
   }
   function draw_legend() {                                     // an entry in white is words alone; one without a line is left out
      const used = new Set(panels_of().flatMap(lines_of).flatMap(l => l.keys))
      const of_profile = p => ({id: name_of(p), text: name_of(p), look: look_of(p), note: D.cases[p.case].converged ? '' : ' (no equilibrium)'})
      const entries = S.profiles ? shown().map(of_profile) : S.keys.map((k, id) => ({...k, id, look: look_in(k), note: ''})).filter(k => k.words || used.has(k.id))
      view.legend.replaceChildren()
      for (const entry of entries) {
         const {id, text, look, note, words} = entry
         if (words) { make(view.legend, 'h:span', {}, text); continue }
         const turn = () => { state.hidden.has(id) ? state.hidden.delete(id) : state.hidden.add(id); draw() }
         const b = make(view.legend, 'h:button', {type: 'button', 'aria-pressed': !state.hidden.has(id), onclick: turn})
         draw_key(b, entry, look)
         b.append(text + note)
      }
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
      if (S.leads) make(root, 'h:h3', {}, S.leads)
      const bar = make(root, 'h:div', {class: 'bar'}), zoom = (top, bottom) => { state.top = top; state.bottom = bottom; draw() }
      const whole = () => zoom(first, end_of()), lowest = 'lowest ' + round_text(shown_length)
      const button = (text, onclick, more) => make(bar, 'h:button', {type: 'button', onclick, ...more}, text)
      const choose = i => { state.chart = i; bar.querySelectorAll('.tab').forEach((o, k) => o.setAttribute('aria-pressed', k === i)); draw() }
      if (S.charts) S.charts.forEach((c, i) => button(c.title, () => choose(i), {'aria-pressed': i === state.chart, class: 'tab'}))
      const next_units = () => {
         units = D.systems[(D.systems.indexOf(units) + 1) % D.systems.length]
         for (const b of blocks) b.draw()
      }
      view.units = S.leads === '' ? make(null, 'h:p', {}) : button('', next_units)      // once a picture
      if (!S.rows) button('whole depth', whole)
      if (S.profiles) button(lowest, () => zoom(Math.max(0, end_of() - shown_length), end_of()))
      const main = make(root, 'h:div', {class: S.profiles ? 'main' : 'alone'})
      if (S.profiles) {
         const side = make(main, 'h:div', {class: 'side'})
         choice(side, 'Load cases', D.cases.map(c => c.name), state.cases)
         choice(side, 'Models', D.models, state.models)
      }
      const right = make(main, 'h:div', {class: 'right'})
      view.legend = make(right, 'h:div', {class: 'legend'})
      view.panels = make(right, 'h:div', {class: 'panels'})
      view.slider = make(right, 'h:input', {type: 'range', step: S.rows ? 1 : 'any', 'aria-label': S.over ?? 'row', oninput: e => set_depth(+e.target.value)})
      if (S.over && !blocks.some(b => b.S.over)) make(right, 'h:p', {class: 'hint'}, 'Point at a depth to read all curves there. Drag up or down, or spread two fingers, to zoom. Double click for the whole depth. Arrow keys move the slider. '
         + `Curves are within ${100 * D.tolerance} % of their range of those in the CSV files.`)
      if (S.profiles) {
         view.well = well_figures({root, state, shown, look_of, name_of, place_text, set_depth})
         const l = make(root, 'h:label', {})
         view.all = make(l, 'h:input', {type: 'checkbox', onchange: draw_readout})
         l.append(' all columns')
      }
      view.readout = make(root, 'h:div', {class: 'wide readout'})
      let from = null, band = null
      const y_in = e => { const s = e.target.closest('svg.panel'); if (!s) return null; const r = s.getBoundingClientRect(); return (e.clientY - r.top) / r.height * H }
      const show_band = (a, b) => { for (const s of view.panels.children) { s.band ??= make(s, 'rect', {x: 0, width: '100%', class: 'band'}); s.band.setAttribute('y', Math.min(a, b)); s.band.setAttribute('height', Math.abs(b - a)) } }
      view.panels.addEventListener('pointerdown', e => { const y = y_in(e); if (y === null) return; if (e.pointerType === 'mouse' && !S.rows) { from = y; e.preventDefault() } set_depth(depth_of(y)) })
      view.panels.addEventListener('pointermove', e => {
         const y = y_in(e)
         if (y === null) return
         set_depth(depth_of(y))
         if (from !== null) { show_band(from, y); band = y }
      })
      addEventListener('pointerup', () => {
         if (from !== null && band !== null && Math.abs(band - from) > 6) zoom(Math.max(first, depth_of(Math.min(from, band))), Math.min(end_of(), depth_of(Math.max(from, band))))
         else if (from !== null) draw_panels()
         from = band = null
      })
      let pinch = null                                          // two fingers: the depths between which they began are spread
      const fingers = e => [...e.touches].map(t => { const r = view.panels.firstChild.getBoundingClientRect(), s = t.target.closest?.('svg.panel')?.getBoundingClientRect() ?? r; return (t.clientY - s.top) / s.height * H }).sort((a, b) => a - b)
      view.panels.addEventListener('touchstart', e => { if (e.touches.length === 2 && !S.rows) { e.preventDefault(); pinch = {depths: fingers(e).map(depth_of)} } }, {passive: false})
      view.panels.addEventListener('touchmove', e => {
         if (!pinch || e.touches.length !== 2) return
         e.preventDefault()
         const [a, b] = fingers(e), step = (pinch.depths[1] - pinch.depths[0]) / Math.max(b - a, 20)
         pinch.top = Math.max(0, pinch.depths[0] - step * (a - up)); pinch.bottom = Math.min(end_of(), pinch.top + step * (H - up - down))
         show_band(y_of(pinch.top), y_of(pinch.bottom))
      }, {passive: false})
      view.panels.addEventListener('touchend', () => { if (pinch?.bottom > pinch?.top) zoom(pinch.top, pinch.bottom); pinch = null })
      view.panels.addEventListener('dblclick', whole)
      let wide = 0
      new ResizeObserver((_, observer) => {                     // a block that was replaced is looked at no longer
         if (!view.panels.isConnected) observer.disconnect()
         else if (view.panels.clientWidth !== wide) { wide = view.panels.clientWidth; draw_panels(); view.well?.draw_assembly() }
      }).observe(view.panels)
      for (const kind of ['pointerenter', 'focusin']) root.addEventListener(kind, () => active = S)
      state.bottom ||= end_of(); state.depth ??= S.rows ? 1 : S.end ?? state.bottom / 2
      draw()
   }
   function from_address(q) {                                    // #case=NAME&case=NAME&chart=TITLE&depth=M&top=M&bottom=M&units=field
      const found = (list, name) => list.findIndex(c => (c.name ?? c.title) === name)
      if (S.profiles && q.has('case')) state.cases = q.getAll('case').map(n => found(D.cases, n)).filter(i => i >= 0)
      if (S.profiles && q.has('chart')) state.chart = Math.max(0, found(D.charts, q.get('chart')))
      for (const k of ['depth', 'top', 'bottom']) if (isFinite(parseFloat(q.get(k)))) state[k] = parseFloat(q.get(k))
   }
   function note_address() {                                     // after a pause: the view is a link
      if (active !== S) return
      clearTimeout(noting)
      noting = setTimeout(() => {
         const q = new URLSearchParams()
         for (const i of S.profiles ? state.cases : []) q.append('case', D.cases[i].name)
         q.set('chart', S.title ?? S.charts[state.chart].title)
         q.set('depth', +state.depth.toFixed(2))
         if (state.top > first || state.bottom < end_of()) { q.set('top', +state.top.toFixed(2)); q.set('bottom', +state.bottom.toFixed(2)) }
         if (units !== D.units) q.set('units', units)
         history.replaceState(null, '', '#' + q)
      }, 300)
   }
   if (active === S) from_address(new URLSearchParams(location.hash.slice(1)))
   build()
   return {root, S, state, draw}
}

// ---- the page
function parts_of_page() {                                    // the place and the data of each block
   const list = D.figures.flatMap(f => f.blocks.map((b, i) => {
      const title = f.title + (i ? ` (${i + 1})` : '')
      return {...b, keys: f.keys, place: f, leads: i ? '' : f.title, title}
   }))
   if (D.profiles) list.unshift({profiles: D.profiles, charts: D.charts, over: 'measured depth', place: null})
   return list
}
function follow_address(all) {                                // the block that the address means
   const q = new URLSearchParams(location.hash.slice(1))
   if (D.systems.includes(q.get('units'))) units = q.get('units')
   active = all.find(S => S.title && S.title === q.get('chart')) ?? all[0]
}
addEventListener('hashchange', () => {
   follow_address(blocks.map(b => b.S))
   const i = blocks.findIndex(b => b.S === active), {root, S} = blocks[i]
   root.replaceChildren()
   blocks[i] = block(root, S)
   root.scrollIntoView()
})
const places = [...document.querySelectorAll('.live')]
try {
   const all = parts_of_page(), owners = [...(D.profiles ? [null] : []), ...D.figures]
   follow_address(all)
   for (const S of all) blocks.push(block(make(places[owners.indexOf(S.place)], 'h:div', {}), S))
   document.documentElement.classList.add('scripted')
   if (location.hash) blocks.find(b => b.S === active).root.scrollIntoView()
} catch (fault) {                                             // fixed pictures, as without a script
   for (const place of places) place.replaceChildren()
   throw fault
}
