!> The script and the style that a page carries: page.js, well.js, page.css. The hash of the script lets it run.
!> Written by .ci/embed_page.py --write; change those files, not this.
module dg_page_script
   implicit none
   private
   public :: script_hash, script_lines, style_lines

   character(*), parameter :: script_hash = 'qtjBR9sZfBnrXtKo+iD58Wvd4x+nzh4Pn0UhQgsZF4k='
   character(238), parameter :: script_lines_1(100) = [character(238) :: &
      '''use strict''', &
      'const D = JSON.parse(document.getElementById(''data'').textContent)', &
      'const NS = ''http://www.w3.org/2000/svg''', &
      'const colours = [''#0072B2'', ''#D55E00'', ''#009E73'', ''#CC79A7'', ''#56B4E9'', ''#E69F00'', ''#7f6fd0'', '''// &
      '#999999'']', &
      'const dashes = ['''', ''8 4'', ''2 3'', ''8 3 2 3'']', &
      'const shapes = [''m0-5v10m-5-5h10'', ''m-4-4l8 8m0-8l-8 8'', ''m0-5v10m-4.3-7.5l8.6 5m0-5l-8.6 5'', ''m-4-4h8v'// &
      '8h-8z'', ''m-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z'',', &
      '''m0-5l5 8.5h-10z'', ''m0 5l5-8.5h-10z'', ''m0-5.5l4.5 5.5l-4.5 5.5l-4.5-5.5z'', ''m0-5l4.8 3.5l-1.8 5.5h-6l-1'// &
      '.8-5.5z'']   // gnuplot''s marks', &
      'const blocks = []                                            // all charts of the page that answer', &
      'const shown_length = 40 / D.quantities.length.SI[1]          // of the assembly in its hole', &
      'let units = D.systems.includes(D.units) ? D.units : D.systems[0], clips = 0, noting = 0, active = null', &
      'function curve_of(text) {                                    // "step value step value ..." in thousandths of '// &
      'D.units'' length', &
      'const t = text === '''' ? [] : text.split('' ''), n = t.length / 2, d = new Float64Array(n), v = new Float64Ar'// &
      'ray(n)', &
      'for (let i = 0, sum = 0; i < n; i++) { d[i] = (sum += +t[2 * i]) / 1000; v[i] = t[2 * i + 1] === '''' ? NaN : '// &
      '+t[2 * i + 1] }', &
      'return {d, v}', &
      '}', &
      'for (const p of D.profiles ?? []) for (const name in p.curves)', &
      'p.curves[name] = typeof p.curves[name] === ''number'' ? D.profiles[p.curves[name]].curves[name] : curve_of(p.c'// &
      'urves[name])   // a number: the same as an earlier one', &
      'const look_in = c => ({stroke: c.stroke ?? ''none'', ''stroke-dasharray'': c.dash ?? ''''})', &
      'for (const f of D.figures) for (const b of f.blocks) for (const panel of b.panels) for (const line of panel.li'// &
      'nes) {', &
      'line.name ||= line.keys.map(k => f.keys[k].text).join('', '')', &
      'if (!line.keys.length) {                                  // an entry of its own', &
      'const i = f.keys.findIndex(k => k.text === line.name)', &
      'line.keys = [i < 0 ? f.keys.push({...line, text: line.name}) - 1 : i]', &
      '}', &
      'line.look = look_in(line)', &
      'line.quantity = panel.quantity', &
      'line.curve = curve_of(line.points)', &
      'if (line.low) { line.low = curve_of(line.low).v; line.high = curve_of(line.high).v }', &
      '}', &
      'const column = name => D.columns[name]', &
      'const factor = q => D.quantities[q]?.[units]?.[1] ?? 1, unit = q => D.quantities[q]?.[units]?.[0] ?? q', &
      'function row_at(c, depth) {                                  // last row at or above a depth', &
      'let low = 0, high = c.d.length - 1', &
      'while (high - low > 1) { const m = (low + high) >> 1; if (c.d[m] <= depth) low = m; else high = m }', &
      'return low', &
      '}', &
      'function value_in(c, depth, words, turns) {', &
      'if (!c || !(depth >= c.d[0] && depth <= c.d[c.d.length - 1])) return NaN', &
      'const i = row_at(c, depth), step = c.d[i + 1] - c.d[i]', &
      'if (words) return c.v[depth - c.d[i] < c.d[i + 1] - depth ? i : i + 1]', &
      'if (depth === c.d[i] || depth === c.d[i + 1]) return c.v[depth === c.d[i] ? i : i + 1]   // a value may lack b'// &
      'eside it', &
      'let turn = c.v[i + 1] - c.v[i]', &
      'if (turns) turn = ((turn + 540) % 360) - 180              // the short way round', &
      'const v = c.v[i] + (step > 0 ? (depth - c.d[i]) / step * turn : 0)', &
      'return turns ? (v + 360) % 360 : v', &
      '}', &
      'const value_at = (p, name, depth) => value_in(p.curves[name], depth, column(name).words, name === ''clock'')', &
      'function text_of(value, q) {', &
      'if (!isFinite(value)) return ''\u2013''', &
      'const v = value * factor(q), a = Math.abs(v)', &
      'return v.toFixed(a >= 1000 ? 0 : a >= 100 ? 1 : a >= 10 ? 2 : 3)', &
      '}', &
      'const depth_text = depth => text_of(depth, ''length'') + '' '' + unit(''length'')', &
      'const round_text = depth => text_of(depth, ''length'').replace(/\.0+$/, '''') + '' '' + unit(''length'')', &
      'function make(parent, tag, attributes, text) {', &
      'const e = tag.startsWith(''h:'') ? document.createElement(tag.slice(2)) : document.createElementNS(NS, tag)', &
      'for (const k in attributes) if (k.startsWith(''on'')) e.addEventListener(k.slice(2), attributes[k]); else e.se'// &
      'tAttribute(k, attributes[k])', &
      'if (text !== undefined) e.textContent = text', &
      'parent?.append(e)', &
      'return e', &
      '}', &
      'function ticks(low, high, most) {', &
      'const raw = (high - low) / most, power = 10 ** Math.floor(Math.log10(raw)), step = power * [1, 2, 5, 10].find('// &
      'f => f * power >= raw)', &
      'const list = []', &
      'for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) list.push(+(i * step).toPrecis'// &
      'ion(12))', &
      'return list', &
      '}', &
      'function colour(t) {                                         // dark blue, green, yellow, red', &
      'const stops = [[70, 100, 215], [20, 145, 140], [120, 190, 70], [245, 215, 60], [210, 50, 30]], x = Math.min(Ma'// &
      'th.max(t, 0), 1) * 4, i = Math.min(3, Math.floor(x))', &
      'return ''rgb('' + stops[i].map((a, k) => Math.round(a + (stops[i + 1][k] - a) * (x - i))).join() + '')''', &
      '}', &
      'function marks_path(curve, x_of, y_of, [from, to], shape) {  // marks that would hide each other are one', &
      'let path = '''', last = ''''', &
      'for (let i = from; i < to; i++) if (isFinite(curve.v[i])) {', &
      'const at = x_of(curve.v[i]).toFixed(0) + '' '' + y_of(curve.d[i]).toFixed(0)', &
      'if (at !== last) path += ''M'' + at + shape', &
      'last = at', &
      '}', &
      'return path', &
      '}', &
      'const shape_of = mark => shapes[mark < 4 ? mark - 1 : (mark >> 1) + 1], filled = (mark, ink) => (mark > 4 && m'// &
      'ark % 2 ? ink : ''none'')', &
      'function draw_key(parent, {mark, marks}, look) {             // a piece of a line, or a mark', &
      'const svg = make(parent, ''svg'', {viewBox: ''0 -4 28 16'', class: ''key''})', &
      'if (!marks) make(svg, ''line'', {x1: 0, x2: 28, y1: 4, y2: 4, ''stroke-width'': 3, ...look})', &
      'if (mark) make(svg, ''path'', {d: ''M14 4'' + shape_of(mark), fill: filled(mark, look.stroke), stroke: look.st'// &
      'roke, ''stroke-width'': 1.6})', &
      '}', &
      'function block(root, S) {', &
      'const end_of = () => S.rows ? S.rows.length + .6 : S.end ?? Math.max(...(state.cases.length ? state.cases : [D'// &
      '.start]).map(i => D.cases[i].depth))', &
      'const first = S.rows ? .4 : 0', &
      'const state = {cases: [D.start], models: [0, 1].filter(i => i < (D.models ?? []).length), chart: 0, top: first'// &
      ', bottom: 0, depth: undefined,', &
      'tint: ''side_force_on_joint'', yaw: -0.6, pitch: 0.35, near: 1, hidden: new Set()}', &
      'const view = {}, H = S.rows ? 64 + 24 * S.rows.length : 420, up = 30, down = 26', &
      'const shown = () => (S.profiles ?? []).filter(p => state.cases.includes(p.case) && state.models.includes(p.mod'// &
      'el))', &
      'const look_of = p => ({stroke: colours[(state.cases.length > 1 ? state.cases.indexOf(p.case) : p.model) % 8], '// &
      '''stroke-dasharray'': dashes[p.model]})', &
      'const name_of = p => D.cases[p.case].name + '' '' + D.models[p.model]', &
      'const visible = line => !line.keys.some(k => state.hidden.has(k))', &
      'const y_of = depth => up + (depth - state.top) / (state.bottom - state.top) * (H - up - down)', &
      'const depth_of = y => state.top + (y - up) / (H - up - down) * (state.bottom - state.top)', &
      'const place_text = () => S.rows ? S.rows[state.depth - 1] : depth_text(state.depth)', &
      'const panels_of = () => S.panels ?? S.charts[state.chart].panels']
   character(238), parameter :: script_lines_2(100) = [character(238) :: &
      'function lines_of(panel) {                                   // its own, or those of the profiles that are sho'// &
      'wn', &
      'if (panel.lines) return panel.lines', &
      'const list = []', &
      'for (const p of shown()) for (const c of panel.curves) if (p.curves[c.column] && (!c.limit || p === shown()[0]'// &
      '))', &
      'list.push({', &
      'name: name_of(p), keys: [name_of(p)], quantity: column(c.column).quantity,', &
      'curve: p.curves[c.column], sign: c.sign ?? 1, turns: c.column === ''clock'', limit: c.limit,', &
      'look: c.limit ? {stroke: ''currentColor'', ''stroke-dasharray'': ''2 3'', ''stroke-width'': 1} : look_of(p)', &
      '})', &
      'return list', &
      '}', &
      'function row_beside(line, depth) {                           // of marks the nearest one, if it is near', &
      'let least = S.rows ? .5 : 6 / (H - up - down) * (state.bottom - state.top), best = -1', &
      'line.curve.d.forEach((d, i) => { if (Math.abs(d - depth) <= least && isFinite(line.curve.v[i])) { least = Math'// &
      '.abs(d - depth); best = i } })', &
      'return best', &
      '}', &
      'function value_of(line, depth) {', &
      'if (line.marks) return line.curve.v[row_beside(line, depth)] ?? NaN', &
      'return (line.sign ?? 1) * value_in(line.curve, depth, false, line.turns)', &
      '}', &
      'function told_of(line) {', &
      'const text = text_of(value_of(line, state.depth), line.quantity), i = line.low ? row_beside(line, state.depth)'// &
      ' : -1', &
      'return i < 0 ? text : `${text} (${text_of(line.low[i], line.quantity)} to ${text_of(line.high[i], line.quantit'// &
      'y)})`', &
      '}', &
      'function path_of(curve, [from, to], x_of, turns) {', &
      'let path = '''', gap = true, at = NaN, few = []', &
      'const flush = () => {', &
      'if (few.length > 4) {', &
      'const x = few.map(a => a[0]), least = x.indexOf(Math.min(...x)), most = x.indexOf(Math.max(...x))', &
      'few = [...new Set([0, least, most, few.length - 1])].sort((a, b) => a - b).map(i => few[i])', &
      '}', &
      'for (const [x, y] of few) { path += (gap ? ''M'' : ''L'') + x.toFixed(1) + '' '' + y.toFixed(1) + (gap ? ''h0'''// &
      ' : ''''); gap = false }', &
      'few = []', &
      '}', &
      'for (let i = from; i < to; i++) {', &
      'if (!isFinite(curve.v[i])) { flush(); gap = true; continue }', &
      'if (turns && i && Math.abs(curve.v[i] - curve.v[i - 1]) > 180) { flush(); gap = true }', &
      'const y = y_of(curve.d[i]), row = Math.round(y)', &
      'if (row !== at) { flush(); at = row }', &
      'few.push([x_of(curve.v[i]), y])', &
      '}', &
      'flush()', &
      'return path', &
      '}', &
      'function range_of(panel, lists, rows) {                      // of what is seen; along the string 0 is among i'// &
      't', &
      'let low = panel.low ?? (S.profiles ? 0 : Infinity), high = panel.high ?? (S.profiles ? 0 : -Infinity)', &
      'const take = v => { if (isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v) } }', &
      'if (panel.high === undefined) {', &
      'lists.forEach((l, k) => {', &
      'if (l.limit || !visible(l)) return', &
      'for (let i = rows[k][0]; i < rows[k][1]; i++) {', &
      'take((l.sign ?? 1) * l.curve.v[i])', &
      'if (l.low) { take(l.low[i]); take(l.high[i]) }', &
      '}', &
      '})', &
      'if (!(low < high)) { const middle = isFinite(low) ? low : 0; low = middle - 1; high = middle + 1 }', &
      'const air = (high - low) * .05', &
      'if (low !== (panel.low ?? 0)) low -= air', &
      'high += air', &
      '}', &
      'return [low, Math.min(high, panel.most ?? Infinity)]', &
      '}', &
      'function rows_of({curve, marks}) {                           // of its points those that can be seen: from, an'// &
      'd before', &
      'const all = curve.d.length', &
      'return marks ? [0, all] : [row_at(curve, state.top), Math.min(all, row_at(curve, state.bottom) + 2)]', &
      '}', &
      'function draw_axes(svg, left, right, index) {                // depths, or names of rows', &
      'const level = (at, text) => {', &
      'const y = y_of(at), most = Math.floor((left - 6) / 6.4), name = String(text), long = name.length > most', &
      'make(svg, ''line'', {x1: left, x2: right, y1: y, y2: y, class: ''grid''})', &
      'if (index) return', &
      'const short = long ? name.slice(0, most - 1) + ''\u2026'' : name', &
      'const label = make(svg, ''text'', {x: left - 4, y: y + 4, ''text-anchor'': ''end''}, short)', &
      'if (long) make(label, ''title'', {}, name)', &
      '}', &
      'const length = factor(''length'')', &
      'if (S.rows) S.rows.forEach((name, i) => level(i + 1, name))', &
      'else for (const t of ticks(state.top * length, state.bottom * length, 9)) level(t / length, t)', &
      '}', &
      'function draw_label(svg, label, brackets, left, right) {     // a long one goes on beside its unit', &
      'const most = Math.floor((right - left) / 6.7), end = label.length > most ? label.lastIndexOf('' '', most) : la'// &
      'bel.length', &
      'make(svg, ''text'', {x: left, y: 12, class: ''label''}, label.slice(0, end))', &
      'const second = make(svg, ''text'', {x: left, y: 25}, '''')', &
      'make(second, ''tspan'', {class: ''label''}, label.slice(end + 1))', &
      'second.append('' '' + brackets)', &
      '}', &
      'function draw_line(clip, line, rows, x_of) {', &
      'const {look, mark, curve} = line, x = v => x_of((line.sign ?? 1) * v), ink = look.stroke', &
      'const put_marks = (curve, rows) => {', &
      'const d = marks_path(curve, x, y_of, rows, shape_of(mark))', &
      'make(clip, ''path'', {d, ''stroke-width'': 1.5, fill: filled(mark, ink), stroke: ink})', &
      '}', &
      'if (line.low) {                                           // bars, with a mark in thick ones', &
      'curve.d.forEach((d, i) => {', &
      'const ends = {x1: x(line.low[i]), x2: x(line.high[i]), y1: y_of(d), y2: y_of(d)}', &
      'make(clip, ''line'', {...ends, stroke: ink, ''stroke-width'': line.thick ? 14 : 2})', &
      '})', &
      'if (line.thick) put_marks(curve, rows)', &
      '} else if (line.marks) {', &
      'put_marks(curve, rows)']
   character(238), parameter :: script_lines_3(100) = [character(238) :: &
      '} else {', &
      'const d = path_of(curve, rows, x, line.turns)', &
      'make(clip, ''path'', {d, fill: ''none'', ''stroke-width'': 1.7, ''stroke-linecap'': ''round'', ...look})', &
      'if (!mark) return', &
      'const at = Array.from({length: 8}, (_, i) => state.top + (i + .5) / 8 * (state.bottom - state.top))', &
      'put_marks({d: at, v: at.map(d => value_in(curve, d))}, [0, at.length])', &
      '}', &
      '}', &
      'function draw_panel(panel, index, width) {', &
      'const svg = make(null, ''svg'', {viewBox: `0 0 ${width} ${H}`, role: ''img'', ''aria-label'': panel.label, cla'// &
      'ss: ''panel''})', &
      'const longest = S.rows ? Math.max(...S.rows.map(n => n.length)) : 0', &
      'const left = index ? 12 : S.rows ? Math.min(.4 * width, 12 + 6.4 * longest) : 46, right = width - 10', &
      'const lists = lines_of(panel), rows = lists.map(rows_of), q = panel.quantity ?? column(panel.curves[0].column)'// &
      '.quantity, f = factor(q)', &
      'const [low, high] = range_of(panel, lists, rows).map(v => v * f)', &
      'const x_of = v => left + (v * f - low) / (high - low) * (right - left)', &
      'make(make(svg, ''clipPath'', {id: ''clip'' + ++clips}), ''rect'', {x: left, y: up, width: right - left, height'// &
      ': H - up - down})', &
      'for (const t of panel.ticks ?? ticks(low, high, Math.max(3, (right - left) / 50))) {', &
      'const x = left + (t - low) / (high - low) * (right - left)', &
      'make(svg, ''line'', {x1: x, x2: x, y1: up, y2: H - down, class: t ? ''grid'' : ''zero''})', &
      'make(svg, ''text'', {x, y: H - down + 15, ''text-anchor'': ''middle''}, t)', &
      '}', &
      'draw_axes(svg, left, right, index)', &
      'make(svg, ''rect'', {x: left, y: up, width: right - left, height: H - up - down, class: ''frame''})', &
      'draw_label(svg, panel.label, unit(q) && `[${unit(q)}]`, left, right)', &
      'const clip = make(svg, ''g'', {''clip-path'': `url(#clip${clips})`})', &
      'lists.forEach((line, k) => { if (visible(line)) draw_line(clip, line, rows[k], x_of) })', &
      'const cross = make(svg, ''g'', {class: ''cross''})', &
      'svg.cross = () => {', &
      'cross.replaceChildren()', &
      'if (state.depth < state.top || state.depth > state.bottom) return', &
      'const y = y_of(state.depth), seen = lists.filter(l => visible(l) && !l.limit && isFinite(value_of(l, state.dep'// &
      'th)))', &
      'make(cross, ''line'', {x1: left, x2: right, y1: y, y2: y})', &
      'if (S.rows) return', &
      'seen.forEach((line, k) => {', &
      'const v = value_of(line, state.depth), x = x_of(v), ink = line.look.stroke', &
      'if (x >= left && x <= right) make(cross, ''circle'', {cx: x, cy: y, r: 3.5, fill: ink})', &
      'if (seen.length < 7) make(cross, ''text'', {x: right - 3, y: (y < 100 ? y + 14 : y - 5) + (y < 100 ? 1 : -1) *'// &
      ' 13 * k, ''text-anchor'': ''end'', style: ''fill:'' + ink, class: ''value''}, text_of(v, q))', &
      '})', &
      'if (!index) make(cross, ''text'', {x: left + 3, y: y < 100 ? y + 14 : y - 5, class: ''value''}, place_text())', &
      '}', &
      'return svg', &
      '}', &
      'function draw_panels() {', &
      'const panels = panels_of(), bare = S.profiles !== undefined && !shown().length', &
      'root.classList.toggle(''bare'', bare)                       // an empty chart is not drawn', &
      'if (bare) {', &
      'const names = state.cases.map(i => D.cases[i].name).join('', '')', &
      'view.panels.replaceChildren(make(null, ''h:p'', {class: ''note''}, state.cases.length * state.models.length', &
      '? `No curves: no solution of ${names}. Answers and warnings above say why.` : ''No curves: choose a load case '// &
      'and a model.''))', &
      'return', &
      '}', &
      'const wide = view.panels.clientWidth || 1000, abreast = Math.min(panels.length, wide >= 600 ? Infinity : S.row'// &
      's ? 1 : 2)', &
      'view.panels.replaceChildren(...panels.map((p, i) => draw_panel(p, i % abreast, Math.max(150, wide / abreast)))'// &
      ')', &
      'for (const s of view.panels.children) s.style.width = 100 / abreast + ''%''', &
      'draw_cross()', &
      '}', &
      'const reach = () => S.rows ? [1, S.rows.length] : [state.top, state.bottom]', &
      'function set_depth(depth) {', &
      'const [low, high] = reach()', &
      'state.depth = Math.min(Math.max(S.rows ? Math.round(depth) : depth, low), high)', &
      'draw_cross()', &
      '}', &
      'let waiting = false', &
      'function draw_cross() {', &
      'if (waiting) return', &
      'waiting = true', &
      'requestAnimationFrame(() => {', &
      'waiting = false', &
      'for (const s of view.panels.children) s.cross()', &
      'const [min, max] = reach()', &
      'Object.assign(view.slider, {min, max, value: state.depth})', &
      'view.slider.setAttribute(''aria-valuetext'', told())', &
      'view.well?.mark()', &
      'draw_readout()', &
      'note_address()', &
      '})', &
      '}', &
      'function told() {                                            // what a screen reader says', &
      'return place_text() + '', '' + panels_of().map(a => a.label + '' '' + lines_of(a).filter(l => visible(l) && is'// &
      'Finite(value_of(l, state.depth)))', &
      '.map(l => l.name + '' '' + told_of(l)).join('', '')).join(''; '')', &
      '}', &
      'function cells_of_profiles() {                               // a row a quantity', &
      'const list = shown().filter(p => !state.hidden.has(name_of(p))), wanted = panels_of().flatMap(p => p.curves.ma'// &
      'p(c => c.column))', &
      'const names = view.all.checked ? Object.keys(D.columns) : [...new Set(wanted)], both = list.length === 2', &
      'return [[''quantity'', ''unit'', ...list.map(name_of), ...(both ? [''difference''] : [])], ...names.map(n => {', &
      'const c = column(n), v = list.map(p => value_at(p, n, state.depth))', &
      'return [[c.label, c.meaning], unit(c.quantity), ...v.map(x => c.words ? c.words[x] ?? ''\u2013'' : text_of(x, '// &
      'c.quantity)), ...(both ? [c.words ? '''' : text_of(v[1] - v[0], c.quantity)] : [])]', &
      '})]', &
      '}', &
      'const reaches = ({curve: {d}}) => state.depth >= d[0] && state.depth <= d[d.length - 1]', &
      'function cells_of_lines() {                                  // a row a line: all that reach the depth, of mar'// &
      'ks those that are near', &
      'const panels = panels_of(), lines = panels.map(p => lines_of(p).filter(visible))', &
      'const told = lines.flat().filter(l => l.marks ? isFinite(value_of(l, state.depth)) : reaches(l))', &
      'const heads = panels.map(p => p.label + (unit(p.quantity) ? ` [${unit(p.quantity)}]` : ''''))', &
      'const cell = (name, list) => list.filter(l => l.name === name).map(told_of).find(text => text !== ''\u2013'') '// &
      '?? ''\u2013''', &
      'return [[''curve'', ...heads], ...[...new Set(told.map(l => l.name))].map(name => [name, ...lines.map(list => '// &
      'cell(name, list))])]', &
      '}', &
      'function draw_readout() {', &
      'const table = make(null, ''h:table'', {}), [head, ...rows] = S.profiles ? cells_of_profiles() : cells_of_lines'// &
      '()', &
      'make(table, ''h:caption'', {}, ''At '' + place_text() + (S.rows ? '''' : '' '' + S.over))']
   character(238), parameter :: script_lines_4(100) = [character(238) :: &
      'const heads = make(make(table, ''h:thead'', {}), ''h:tr'', {}), body = make(table, ''h:tbody'', {})', &
      'head.forEach((t, i) => make(heads, ''h:th'', {scope: ''col'', ...(i ? {} : {class: ''text''})}, t))', &
      'for (const row of rows) {', &
      'const line = make(body, ''h:tr'', {})', &
      'row.forEach((t, i) => {', &
      'const [text, title] = [t].flat()', &
      'make(line, ''h:td'', {...(i ? {} : {class: ''text''}), ...(title ? {title} : {})}, text)', &
      '})', &
      '}', &
      'view.readout.replaceChildren(table)', &
      '}', &
      'function draw() {', &
      'const end = end_of()', &
      'if (!(state.bottom > state.top) || state.bottom > end) { state.top = first; state.bottom = end }', &
      'state.depth = Math.min(state.depth, state.bottom)', &
      'view.units.textContent = ''units: '' + units', &
      'draw_legend()', &
      'draw_panels()', &
      'view.well?.draw()', &
      '}', &
      'function draw_legend() {                                     // an entry in white is words alone; one without '// &
      'a line is left out', &
      'const used = new Set(panels_of().flatMap(lines_of).flatMap(l => l.keys))', &
      'const of_profile = p => ({id: name_of(p), text: name_of(p), look: look_of(p), note: D.cases[p.case].converged '// &
      '? '''' : '' (no equilibrium)''})', &
      'const entries = S.profiles ? shown().map(of_profile) : S.keys.map((k, id) => ({...k, id, look: look_in(k), not'// &
      'e: ''''})).filter(k => k.words || used.has(k.id))', &
      'view.legend.replaceChildren()', &
      'for (const entry of entries) {', &
      'const {id, text, look, note, words} = entry', &
      'if (words) { make(view.legend, ''h:span'', {}, text); continue }', &
      'const turn = () => { state.hidden.has(id) ? state.hidden.delete(id) : state.hidden.add(id); draw() }', &
      'const b = make(view.legend, ''h:button'', {type: ''button'', ''aria-pressed'': !state.hidden.has(id), onclick:'// &
      ' turn})', &
      'draw_key(b, entry, look)', &
      'b.append(text + note)', &
      '}', &
      '}', &
      'function choice(parent, label, names, list) {                // check boxes', &
      'const box = make(parent, ''h:fieldset'', {})', &
      'make(box, ''h:legend'', {}, label)', &
      'names.forEach((n, i) => {', &
      'const l = make(box, ''h:label'', {}), c = make(l, ''h:input'', {type: ''checkbox'', onchange: () => {', &
      'if (c.checked) list.push(i); else list.splice(list.indexOf(i), 1)', &
      'draw() }})', &
      'c.checked = list.includes(i)', &
      'l.append('' '' + n)', &
      '})', &
      '}', &
      'function build() {', &
      'if (S.leads) make(root, ''h:h3'', {}, S.leads)', &
      'const bar = make(root, ''h:div'', {class: ''bar''}), zoom = (top, bottom) => { state.top = top; state.bottom ='// &
      ' bottom; draw() }', &
      'const whole = () => zoom(first, end_of()), lowest = ''lowest '' + round_text(shown_length)', &
      'const button = (text, onclick, more) => make(bar, ''h:button'', {type: ''button'', onclick, ...more}, text)', &
      'const choose = i => { state.chart = i; bar.querySelectorAll(''.tab'').forEach((o, k) => o.setAttribute(''aria-'// &
      'pressed'', k === i)); draw() }', &
      'if (S.charts) S.charts.forEach((c, i) => button(c.title, () => choose(i), {''aria-pressed'': i === state.chart'// &
      ', class: ''tab''}))', &
      'const next_units = () => {', &
      'units = D.systems[(D.systems.indexOf(units) + 1) % D.systems.length]', &
      'for (const b of blocks) b.draw()', &
      '}', &
      'view.units = S.leads === '''' ? make(null, ''h:p'', {}) : button('''', next_units)      // once a picture', &
      'if (!S.rows) button(''whole depth'', whole)', &
      'if (S.profiles) button(lowest, () => zoom(Math.max(0, end_of() - shown_length), end_of()))', &
      'const main = make(root, ''h:div'', {class: S.profiles ? ''main'' : ''alone''})', &
      'if (S.profiles) {', &
      'const side = make(main, ''h:div'', {class: ''side''})', &
      'choice(side, ''Load cases'', D.cases.map(c => c.name), state.cases)', &
      'choice(side, ''Models'', D.models, state.models)', &
      '}', &
      'const right = make(main, ''h:div'', {class: ''right''})', &
      'view.legend = make(right, ''h:div'', {class: ''legend''})', &
      'view.panels = make(right, ''h:div'', {class: ''panels''})', &
      'view.slider = make(right, ''h:input'', {type: ''range'', step: S.rows ? 1 : ''any'', ''aria-label'': S.over ??'// &
      ' ''row'', oninput: e => set_depth(+e.target.value)})', &
      'if (S.over && !blocks.some(b => b.S.over)) make(right, ''h:p'', {class: ''hint''}, ''Point at a depth to read '// &
      'all curves there. Drag up or down, or spread two fingers, to zoom. Double click for the whole depth. Arrow key'// &
      's move the slider. ''', &
      '+ `Curves are within ${100 * D.tolerance} % of their range of those in the CSV files.`)', &
      'if (S.profiles) {', &
      'view.well = well_figures({root, state, shown, look_of, name_of, place_text, set_depth})', &
      'const l = make(root, ''h:label'', {})', &
      'view.all = make(l, ''h:input'', {type: ''checkbox'', onchange: draw_readout})', &
      'l.append('' all columns'')', &
      '}', &
      'view.readout = make(root, ''h:div'', {class: ''wide readout''})', &
      'let from = null, band = null', &
      'const y_in = e => { const s = e.target.closest(''svg.panel''); if (!s) return null; const r = s.getBoundingCli'// &
      'entRect(); return (e.clientY - r.top) / r.height * H }', &
      'const show_band = (a, b) => { for (const s of view.panels.children) { s.band ??= make(s, ''rect'', {x: 0, widt'// &
      'h: ''100%'', class: ''band''}); s.band.setAttribute(''y'', Math.min(a, b)); s.band.setAttribute(''height'', Ma'// &
      'th.abs(b - a)) } }', &
      'view.panels.addEventListener(''pointerdown'', e => { const y = y_in(e); if (y === null) return; if (e.pointerT'// &
      'ype === ''mouse'' && !S.rows) { from = y; e.preventDefault() } set_depth(depth_of(y)) })', &
      'view.panels.addEventListener(''pointermove'', e => {', &
      'const y = y_in(e)', &
      'if (y === null) return', &
      'set_depth(depth_of(y))', &
      'if (from !== null) { show_band(from, y); band = y }', &
      '})', &
      'addEventListener(''pointerup'', () => {', &
      'if (from !== null && band !== null && Math.abs(band - from) > 6) zoom(Math.max(first, depth_of(Math.min(from, '// &
      'band))), Math.min(end_of(), depth_of(Math.max(from, band))))', &
      'else if (from !== null) draw_panels()', &
      'from = band = null', &
      '})', &
      'let pinch = null                                          // two fingers: the depths between which they began '// &
      'are spread', &
      'const fingers = e => [...e.touches].map(t => { const r = view.panels.firstChild.getBoundingClientRect(), s = t'// &
      '.target.closest?.(''svg.panel'')?.getBoundingClientRect() ?? r; return (t.clientY - s.top) / s.height * H }).s'// &
      'ort((a, b) => a - b)', &
      'view.panels.addEventListener(''touchstart'', e => { if (e.touches.length === 2 && !S.rows) { e.preventDefault('// &
      '); pinch = {depths: fingers(e).map(depth_of)} } }, {passive: false})', &
      'view.panels.addEventListener(''touchmove'', e => {', &
      'if (!pinch || e.touches.length !== 2) return', &
      'e.preventDefault()', &
      'const [a, b] = fingers(e), step = (pinch.depths[1] - pinch.depths[0]) / Math.max(b - a, 20)']
   character(238), parameter :: script_lines_5(100) = [character(238) :: &
      'pinch.top = Math.max(0, pinch.depths[0] - step * (a - up)); pinch.bottom = Math.min(end_of(), pinch.top + step'// &
      ' * (H - up - down))', &
      'show_band(y_of(pinch.top), y_of(pinch.bottom))', &
      '}, {passive: false})', &
      'view.panels.addEventListener(''touchend'', () => { if (pinch?.bottom > pinch?.top) zoom(pinch.top, pinch.botto'// &
      'm); pinch = null })', &
      'view.panels.addEventListener(''dblclick'', whole)', &
      'let wide = 0', &
      'new ResizeObserver((_, observer) => {                     // a block that was replaced is looked at no longer', &
      'if (!view.panels.isConnected) observer.disconnect()', &
      'else if (view.panels.clientWidth !== wide) { wide = view.panels.clientWidth; draw_panels(); view.well?.draw_as'// &
      'sembly() }', &
      '}).observe(view.panels)', &
      'for (const kind of [''pointerenter'', ''focusin'']) root.addEventListener(kind, () => active = S)', &
      'state.bottom ||= end_of(); state.depth ??= S.rows ? 1 : S.end ?? state.bottom / 2', &
      'draw()', &
      '}', &
      'function from_address(q) {                                    // #case=NAME&case=NAME&chart=TITLE&depth=M&top='// &
      'M&bottom=M&units=field', &
      'const found = (list, name) => list.findIndex(c => (c.name ?? c.title) === name)', &
      'if (S.profiles && q.has(''case'')) state.cases = q.getAll(''case'').map(n => found(D.cases, n)).filter(i => i '// &
      '>= 0)', &
      'if (S.profiles && q.has(''chart'')) state.chart = Math.max(0, found(D.charts, q.get(''chart'')))', &
      'for (const k of [''depth'', ''top'', ''bottom'']) if (isFinite(parseFloat(q.get(k)))) state[k] = parseFloat(q.'// &
      'get(k))', &
      '}', &
      'function note_address() {                                     // after a pause: the view is a link', &
      'if (active !== S) return', &
      'clearTimeout(noting)', &
      'noting = setTimeout(() => {', &
      'const q = new URLSearchParams()', &
      'for (const i of S.profiles ? state.cases : []) q.append(''case'', D.cases[i].name)', &
      'q.set(''chart'', S.title ?? S.charts[state.chart].title)', &
      'q.set(''depth'', +state.depth.toFixed(2))', &
      'if (state.top > first || state.bottom < end_of()) { q.set(''top'', +state.top.toFixed(2)); q.set(''bottom'', +'// &
      'state.bottom.toFixed(2)) }', &
      'if (units !== D.units) q.set(''units'', units)', &
      'history.replaceState(null, '''', ''#'' + q)', &
      '}, 300)', &
      '}', &
      'if (active === S) from_address(new URLSearchParams(location.hash.slice(1)))', &
      'build()', &
      'return {root, S, state, draw}', &
      '}', &
      'function parts_of_page() {                                    // the place and the data of each block', &
      'const list = D.figures.flatMap(f => f.blocks.map((b, i) => {', &
      'const title = f.title + (i ? ` (${i + 1})` : '''')', &
      'return {...b, keys: f.keys, place: f, leads: i ? '''' : f.title, title}', &
      '}))', &
      'if (D.profiles) list.unshift({profiles: D.profiles, charts: D.charts, over: ''measured depth'', place: null})', &
      'return list', &
      '}', &
      'function follow_address(all) {                                // the block that the address means', &
      'const q = new URLSearchParams(location.hash.slice(1))', &
      'if (D.systems.includes(q.get(''units''))) units = q.get(''units'')', &
      'active = all.find(S => S.title && S.title === q.get(''chart'')) ?? all[0]', &
      '}', &
      'addEventListener(''hashchange'', () => {', &
      'follow_address(blocks.map(b => b.S))', &
      'const i = blocks.findIndex(b => b.S === active), {root, S} = blocks[i]', &
      'root.replaceChildren()', &
      'blocks[i] = block(root, S)', &
      'root.scrollIntoView()', &
      '})', &
      'const places = [...document.querySelectorAll(''.live'')]', &
      'try {', &
      'const all = parts_of_page(), owners = [...(D.profiles ? [null] : []), ...D.figures]', &
      'follow_address(all)', &
      'for (const S of all) blocks.push(block(make(places[owners.indexOf(S.place)], ''h:div'', {}), S))', &
      'document.documentElement.classList.add(''scripted'')', &
      'if (location.hash) blocks.find(b => b.S === active).root.scrollIntoView()', &
      '} catch (fault) {                                             // fixed pictures, as without a script', &
      'for (const place of places) place.replaceChildren()', &
      'throw fault', &
      '}', &
      '''use strict''', &
      'function well_figures(b) {', &
      'const {root, state, shown, look_of, name_of} = b, view = {}', &
      'function draw_section() {                                    // the hole at the depth, seen down the hole, hig'// &
      'h side up', &
      'const svg = view.section, p0 = shown()[0]', &
      'svg.replaceChildren()', &
      'if (!p0) return', &
      'const hole = value_at(p0, ''hole'', state.depth), s = 88 / hole', &
      'make(svg, ''circle'', {cx: 100, cy: 100, r: 88, class: ''wall''})', &
      'make(svg, ''text'', {x: 100, y: 9, ''text-anchor'': ''middle''}, ''high side'')', &
      'for (const p of shown()) {', &
      'const r = value_at(p, ''displacement'', state.depth) * 2 * s, a = value_at(p, ''clock'', state.depth) * Math.P'// &
      'I / 180', &
      'make(svg, ''circle'', {cx: 100 + r * Math.sin(a), cy: 100 - r * Math.cos(a), r: value_at(p, ''od'', state.dept'// &
      'h) * s, fill: ''none'', ''stroke-width'': 2, ...look_of(p)})', &
      '}', &
      '}', &
      'function draw_3d() {', &
      'const svg = view.well, p = shown()[0]', &
      'svg.replaceChildren()', &
      'if (!p) return', &
      'const end = D.cases[p.case].depth, n = 400, q = column(state.tint).quantity, points = []', &
      'for (let i = 0; i <= n; i++) points.push([''east'', ''north'', ''tvd''].map(a => value_at(p, a, i / n * end)))', &
      'const ends = [0, 1, 2].map(k => [Math.min(0, ...points.map(a => a[k])), Math.max(1, ...points.map(a => a[k]))]'// &
      ')', &
      'const size = Math.max(...ends.map(e => e[1] - e[0])), middle = ends.map(e => (e[0] + e[1]) / 2)', &
      'const box = ends.map((e, k) => (e[1] - e[0] < .2 * size ? [middle[k] - .1 * size, middle[k] + .1 * size] : e))', &
      'const cy = Math.cos(state.yaw), sy = Math.sin(state.yaw), cp = Math.cos(state.pitch), sp = Math.sin(state.pitc'// &
      'h), s = 290 * state.near / size', &
      'const project = a => { const e = a[0] - middle[0], m = a[1] - middle[1], z = a[2] - middle[2], far = e * sy + '// &
      'm * cy', &
      'return [230 + s * (e * cy - m * sy), 180 + s * (z * cp - far * sp), far] }', &
      'const line = (a, b, o) => { const [x1, y1] = project(a), [x2, y2] = project(b); return make(svg, ''line'', {x1'// &
      ', y1, x2, y2, ...o}) }', &
      'const [e0, e1] = box[0], [n0, n1] = box[1], z1 = box[2][1], length = factor(''length'')', &
      'const plan = sp > .7, few = (a, b, room = 60) => Math.min(5, Math.max(1, Math.round((b - a) * s / room)))   //'// &
      ' [px]', &
      'const number = (a, t, look) => { const [x, y] = project(a); make(svg, ''text'', {x: x + look.dx, y: y + look.d'// &
      'y, ''text-anchor'': look.anchor}, t) }', &
      'const below = {dx: 0, dy: 16, anchor: ''middle''}']
   character(238), parameter :: script_lines_6(84) = [character(238) :: &
      'for (const t of ticks(e0 * length, e1 * length, few(e0, e1))) { line([t / length, n0, z1], [t / length, n1, z1'// &
      '], {class: ''grid''})', &
      'if (plan || Math.abs(cy) > .95 && sp < .1) number([t / length, n0, z1], t, below) }', &
      'for (const t of ticks(n0 * length, n1 * length, few(n0, n1))) { line([e0, t / length, z1], [e1, t / length, z1'// &
      '], {class: ''grid''})', &
      'if (plan) number([e0, t / length, z1], t, {dx: -8, dy: 4, anchor: ''end''}); else if (Math.abs(sy) > .95 && sp'// &
      ' < .1) number([e1, t / length, z1], t, below) }', &
      'if (!plan) for (const t of ticks(0, z1 * length, few(0, z1 * cp, 25))) { line([e0, n1, t / length], [e1, n1, t'// &
      ' / length], {class: ''grid''})', &
      'number([e1, n1, t / length], t, {dx: cy * (e1 - e0) > Math.abs(sy) * (n1 - n0) * .2 ? 34 : -8, dy: 4, anchor: '// &
      '''end''}) }', &
      'const [ox, oy] = project(middle)                          // a compass away from the string', &
      'for (const [a, t] of [[[size, 0, 0], ''E''], [[0, size, 0], ''N'']]) {', &
      'const [x, y] = project(a.map((v, k) => v + middle[k])), dx = (x - ox) / (s * size) * 22, dy = (y - oy) / (s * '// &
      'size) * 22', &
      'if (Math.hypot(dx, dy) < 5) continue', &
      'make(svg, ''line'', {x1: 415, y1: 365, x2: 415 + dx, y2: 365 + dy, class: ''zero''})', &
      'make(svg, ''text'', {x: 415 + 1.5 * dx, y: 369 + 1.5 * dy, ''text-anchor'': ''middle'', class: ''label''}, t)', &
      '}', &
      'make(svg, ''path'', {class: ''shadow'', d: ''M'' + points.map(a => { const [x, y] = project([a[0], a[1], z1]);'// &
      ' return x.toFixed(1) + '' '' + y.toFixed(1) }).join(''L'')})', &
      'const values = points.map((a, i) => value_at(p, state.tint, i / n * end)), finite = values.filter(isFinite)', &
      'const sorted = [...finite].sort((a, b) => a - b), low = sorted[0], high = sorted[Math.floor(.99 * (sorted.leng'// &
      'th - 1))]', &
      'for (let i = 0; i < n; i++) line(points[i], points[i + 1], {stroke: isFinite(values[i]) ? colour((values[i] - '// &
      'low) / (high - low || 1)) : ''#888'', ''stroke-width'': 5, ''stroke-linecap'': ''round''})', &
      'for (let i = 0; i < 40; i++) make(svg, ''rect'', {x: 20 + 5 * i, y: 372, width: 5.5, height: 9, fill: colour(i'// &
      ' / 39)})', &
      'make(svg, ''text'', {x: 20, y: 394}, text_of(low, q)); make(svg, ''text'', {x: 220, y: 394, ''text-anchor'': '''// &
      'end''}, (sorted[sorted.length - 1] > high ? ''\u2265 '' : '''') + text_of(high, q))', &
      'make(svg, ''text'', {x: 20, y: 366}, `${column(state.tint).label} [${unit(q)}], ${name_of(p)}`.slice(0, 60))', &
      'const dot = make(svg, ''circle'', {r: 6, class: ''dot''}), words = make(svg, ''text'', {class: ''value''})', &
      'view.mark3d = () => { const [x, y] = project([''east'', ''north'', ''tvd''].map(a => value_at(p, a, Math.min(s'// &
      'tate.depth, end))))', &
      'dot.setAttribute(''cx'', x); dot.setAttribute(''cy'', y); words.setAttribute(''x'', x + 9); words.setAttribute'// &
      '(''y'', y - 6)', &
      'words.textContent = b.place_text() + '': '' + text_of(value_at(p, state.tint, state.depth), q) }', &
      'view.mark3d()', &
      'svg.nearest = (mx, my) => { let best = 0, least = Infinity; points.forEach((a, i) => { const [x, y] = project('// &
      'a), r = (x - mx) ** 2 + (y - my) ** 2; if (r < least) { least = r; best = i } })', &
      'return least < 400 ? best / n * end : null }', &
      '}', &
      'function draw_assembly() {                                   // the lowest 40 m from the side, high side up', &
      'const svg = view.assembly, p = shown()[0], W = Math.max(320, root.clientWidth || 1000), T = 290', &
      'svg.replaceChildren()', &
      'svg.setAttribute(''viewBox'', `0 0 ${W} ${T}`)', &
      'if (!p) return', &
      'const bit = D.cases[p.case].depth, long = shown_length, x_of = d => 10 + (d - (bit - long)) / long * (W - 30)', &
      'const hole = value_at(p, ''hole'', bit), y = v => T / 2 - v / hole * 150', &
      'const off = d => value_at(p, ''displacement'', d) * Math.cos(value_at(p, ''clock'', d) * Math.PI / 180)', &
      'const taken = []                                          // places of texts, the first come first served', &
      'const label = (x, y, text) => {', &
      'const half = 3.6 * text.length, at = Math.min(Math.max(x, half), W - half)', &
      'if (taken.some(t => t.y === y && Math.abs(t.at - at) < t.half + half + 4)) return', &
      'taken.push({at, half, y})', &
      'make(svg, ''text'', {x: at, y, ''text-anchor'': ''middle''}, text)', &
      '}', &
      'const wall = [1, -1].map(sign => Array.from({length: 81}, (_, i) => { const d = bit - long + i * long / 80; re'// &
      'turn x_of(d).toFixed(1) + '' '' + y(sign * value_at(p, ''hole'', d) / 2).toFixed(1) }).join(''L''))', &
      'for (const w of wall) make(svg, ''path'', {d: ''M'' + w, class: ''wall''})', &
      'for (const part of D.cases[p.case].parts) {', &
      'const from = Math.max(bit - part.to, bit - long), to = bit - part.from', &
      'if (to <= bit - long) continue', &
      'const at = Array.from({length: 41}, (_, i) => from + (to - from) * i / 40)', &
      'const edge = sign => at.map(d => x_of(d).toFixed(1) + '' '' + y(off(d) + sign * part.od / 2).toFixed(1))', &
      'make(make(svg, ''path'', {d: ''M'' + edge(1).concat(edge(-1).reverse()).join(''L'') + ''z'', class: ''body''})'// &
      ', ''title'', {}, part.name)', &
      'label((x_of(from) + x_of(to)) / 2, 14, part.name)', &
      '}', &
      'for (const t of ticks(0, long * factor(''length''), W / 120)) label(x_of(bit - t / factor(''length'')), T - 4,'// &
      ' String(t))', &
      'const contacts = (p.contacts ?? []).filter(c => c[0] > bit - long).sort((a, b) => b[1] - a[1])', &
      'for (const [d, force, angle] of contacts) {', &
      'const side = Math.cos(angle * Math.PI / 180) < 0 ? -1 : 1, y0 = y(side * hole / 2), h = side * (8 + 20 * force'// &
      ' / contacts[0][1])', &
      'make(svg, ''line'', {x1: x_of(d), x2: x_of(d), y1: y0 - h, y2: y0, class: ''force''})', &
      'label(x_of(d), side < 0 ? T - 24 : 36, text_of(force, ''force''))', &
      '}', &
      'view.scale.textContent = `The lowest ${round_text(long)}: distance above the bit [${unit(''length'')}], contac'// &
      't forces [${unit(''force'')}], enlarged across the hole.`', &
      '}', &
      'const lower = make(root, ''h:div'', {class: ''lower''})', &
      'view.section = make(make(lower, ''h:figure'', {}), ''svg'', {viewBox: ''0 -6 200 200'', role: ''img'', ''aria-'// &
      'label'': ''string in the hole at this depth''})', &
      'const well = make(lower, ''h:figure'', {}), pick = make(well, ''h:select'', {''aria-label'': ''colour of the w'// &
      'ell'', onchange: e => { state.tint = e.target.value; draw_3d() }})', &
      'for (const n in D.columns) if (!D.columns[n].words) make(pick, ''h:option'', {value: n, ...(n === state.tint ?'// &
      ' {selected: ''''} : {})}, D.columns[n].label)', &
      'const sides = {''3D'': [-0.6, 0.35], plan: [0, Math.PI / 2], ''from south'': [0, 0], ''from east'': [-Math.PI '// &
      '/ 2, 0]}', &
      'for (const name in sides) make(well, ''h:button'', {type: ''button'', onclick: () => { [state.yaw, state.pitch'// &
      '] = sides[name]; draw_3d() }}, name)', &
      'view.well = make(well, ''svg'', {viewBox: ''0 0 460 400'', role: ''img'', ''aria-label'': ''the well in three '// &
      'dimensions'', tabindex: 0})', &
      'const assembly = make(root, ''h:figure'', {})', &
      'view.assembly = make(assembly, ''svg'', {role: ''img'', ''aria-label'': ''lowest part of the string in the hol'// &
      'e''})', &
      'view.scale = make(assembly, ''h:figcaption'', {})', &
      'let turn = null', &
      'view.well.addEventListener(''pointerdown'', e => { turn = [e.clientX, e.clientY]; view.well.setPointerCapture('// &
      'e.pointerId) })', &
      'view.well.addEventListener(''pointermove'', e => {', &
      'if (turn) { state.yaw += (e.clientX - turn[0]) / 150; state.pitch = Math.min(1.5, Math.max(-1.5, state.pitch +'// &
      ' (e.clientY - turn[1]) / 150)); turn = [e.clientX, e.clientY]; draw_3d(); return }', &
      'const r = view.well.getBoundingClientRect(), d = view.well.nearest?.((e.clientX - r.left) / r.width * 460, (e.'// &
      'clientY - r.top) / r.height * 400)', &
      'if (d !== null && d !== undefined) b.set_depth(d)', &
      '})', &
      'view.well.addEventListener(''pointerup'', () => turn = null)', &
      'view.well.addEventListener(''wheel'', e => { e.preventDefault(); state.near *= e.deltaY < 0 ? 1.15 : 1 / 1.15;'// &
      ' draw_3d() }, {passive: false})', &
      'view.well.addEventListener(''keydown'', e => { const k = {ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: ['// &
      '0, -.1], ArrowDown: [0, .1]}[e.key]; if (k) { e.preventDefault(); state.yaw += k[0]; state.pitch += k[1]; draw'// &
      '_3d() } })', &
      'return {draw: () => { draw_3d(); draw_assembly() }, draw_assembly, mark: () => { view.mark3d?.(); draw_section'// &
      '() }}', &
      '}']
   character(238), parameter :: script_lines(584) = [ &
      script_lines_1, &
      script_lines_2, &
      script_lines_3, &
      script_lines_4, &
      script_lines_5, &
      script_lines_6]
   character(271), parameter :: style_lines_1(22) = [character(271) :: &
      '.scripted .static{display:none}', &
      '.live{--ink:#222;--line:#d8d8d8;--soft:#666;--paper:#fff;--wall:#8c6d46;--steel:#b9c4cc}', &
      '.live svg{width:100%;height:auto;display:block}.live svg text{font-size:11px;fill:currentColor}.live svg .labe'// &
      'l{font-weight:600}', &
      '.live .grid{stroke:var(--line);stroke-width:.7}.live .zero{stroke:var(--soft);stroke-width:1}.live .frame{fill'// &
      ':none;stroke:var(--soft)}', &
      '.live .cross line{stroke:#c2185b;stroke-width:1}.live svg .value{font-weight:700;paint-order:stroke;stroke:var'// &
      '(--paper);stroke-width:3px}', &
      '.live .band{fill:#0072B2;opacity:.15}.live .wall{fill:none;stroke:var(--wall);stroke-width:2.5}.live .body{fil'// &
      'l:var(--steel);stroke:var(--ink)}', &
      '.live .force{stroke:#D55E00;stroke-width:3}.live .shadow{fill:none;stroke:var(--soft);stroke-dasharray:3 3}', &
      '.bare>:not(.bar,.main),.bare .legend,.bare .hint,.bare [type=range]{display:none}', &
      '.live .dot{fill:none;stroke:#c2185b;stroke-width:3}', &
      '.bar,.legend{display:flex;flex-wrap:wrap;gap:.4em;margin:.4em 0}.bar button,.legend button,.lower button{font:'// &
      'inherit;padding:.25em .7em;border:1px solid #888;border-radius:4px;background:none;color:inherit;cursor:pointe'// &
      'r}', &
      '.bar .tab[aria-pressed=true]{background:#0072B2;color:#fff}.legend button[aria-pressed=false]{opacity:.4;text-'// &
      'decoration:line-through}', &
      '.legend span{align-self:center;font-size:.85em}.live h3{margin:.8em 0 .2em}', &
      '.live .key{width:28px;height:16px;vertical-align:middle;display:inline-block;margin-right:.4em}', &
      '.main{display:grid;grid-template-columns:11em minmax(0,1fr);gap:1em}.side fieldset{border:1px solid #bbb;margi'// &
      'n:0 0 .6em;padding:.3em .6em;max-height:24em;min-width:0;overflow:auto}', &
      '.side label,.legend button{overflow-wrap:anywhere}.readout th{max-width:9em}', &
      '.side label{display:block;font-size:.85em}.panels{display:flex;flex-wrap:wrap;touch-action:pan-y;user-select:n'// &
      'one;cursor:crosshair}', &
      '.right input[type=range]{width:100%}.hint{font-size:.8em;margin:.2em 0}.lower{display:grid;grid-template-colum'// &
      'ns:13em 1fr;gap:1em}.lower figure{max-width:640px}', &
      ':focus-visible{outline:3px solid #E69F00}', &
      '@media screen and (max-width:700px){.lower figure:first-child{max-width:12em;margin:0 auto}.live figure{margin'// &
      ':1em 0}.main,.lower{grid-template-columns:minmax(0,1fr)}.side{display:grid;grid-template-columns:repeat(2,minm'// &
      'ax(0,1fr));gap:.5em}.side fieldset{max-height:9em}}', &
      '@media screen and (prefers-color-scheme:dark){.live{--ink:#dde2e6;--line:#2f363d;--soft:#8a939b;--paper:#14181'// &
      'c;--wall:#b8935f;--steel:#46525b}.live svg{filter:none}}', &
      '@media print{.live .panels{flex-wrap:nowrap}.live svg.panel{width:0!important;flex:1 1 0}.bar,.side,.hint,.liv'// &
      'e input,.live select,.live label,.live .lower{display:none!important}.main{display:block}', &
      '.alone~.readout{display:none}.right{break-inside:avoid}.live figure svg{max-height:70mm}.live svg.panel{max-he'// &
      'ight:none}.live .alone svg.panel{max-height:105mm}.legend button{border:none}}']
   character(271), parameter :: style_lines(22) = [ &
      style_lines_1]
end module dg_page_script
