!> The script and the style of a page: page.js, curves.js, well.js, page.css. The hash of the script permits it. Written by
!> .ci/embed_page.py --write. Change those files, not this one.
module dg_page_script
   implicit none
   private
   public :: script_hash, script_lines, style_lines

   character(*), parameter :: script_hash = '+4KrfKaDOsa7rDeA1U+BQW1UT7E1upIAJy4wjeGA4vk='
   character(169), parameter :: script_lines_1(100) = [character(169) :: &
      '''use strict''', &
      'const D = JSON.parse(document.getElementById(''data'').textContent)', &
      'const shapes = [''m0-5v10m-5-5h10'', ''m-4-4l8 8m0-8l-8 8'', ''m0-5v10m-4.3-7.5l8.6 5m0-5l-8.6 5'', ''m-4-4h8v'// &
      '8h-8z'',', &
      '''m-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z'', ''m0-5l5 8.5h-10z'', ''m0 5l5-8.5h-10z'', ''m0-5.5l4.5 5.5l-4.5 5.5l-4'// &
      '.5-5.5z'',', &
      '''m0-5l4.8 3.5l-1.8 5.5h-6l-1.8-5.5z'']', &
      'const choices = {case: (D.cases ?? []).map(c => c.name), model: [...new Set((D.profiles ?? []).map(p => p.mode'// &
      'l))]}', &
      'const blocks = []', &
      'const shown_length = 40 / D.quantities.length.SI[1]', &
      'const lowest = () => `lowest ${Math.round(shown_length * factor(''length''))} ${unit(''length'')}`', &
      'let units = D.systems.includes(D.units) ? D.units : D.systems[0], clips = 0, noting = 0, active = null', &
      'let paper = null', &
      'for (const p of D.profiles ?? []) {', &
      'const rows = depths_of((D.profiles[p.depths] ?? p).depths ?? '''')', &
      'for (const name in p.curves) {', &
      'const written = p.curves[name], {words, inverse} = D.columns[name]', &
      'if (typeof written === ''number'') { p.curves[name] = D.profiles[written].curves[name]; continue }', &
      'const curve = curve_of(written, rows)', &
      'p.curves[name] = {...(inverse ? inverse_of(curve) : curve), words, turns: name === ''clock''}', &
      '}', &
      '}', &
      'const mirrored = curve => ({...curve, v: curve.v.map(v => -v)})', &
      'for (const panel of (D.charts ?? []).flatMap(c => c.panels)) {', &
      'panel.quantity = D.columns[panel.curves[0].column].quantity', &
      'panel.lines = D.profiles.flatMap((p, k) => panel.curves.filter(c => p.curves[c.column]).map(c => ({', &
      '...c, name: p.key.text, keys: [k], profile: p, curve: c.limit ? mirrored(p.curves[c.column]) : p.curves[c.colu'// &
      'mn]', &
      '})))', &
      '}', &
      'for (const chart of D.charts ?? []) {', &
      'const turns = ({curves: [{column}], lines}) => column !== ''torque'' || lines.some(l => l.curve.v.some(v => v)'// &
      ')', &
      'chart.panels = chart.panels.filter(turns)', &
      '}', &
      'const meanings = Object.fromEntries(Object.values(D.columns ?? {}).map(c => [c.label, c.meaning]))', &
      'for (const line of D.figures.flatMap(f => f.blocks).flatMap(b => b.panels).flatMap(panel => panel.lines)) {', &
      'line.curve = curve_of(line.points)', &
      'if (line.low) { line.low = curve_of(line.low).v; line.high = curve_of(line.high).v }', &
      '}', &
      'const factor = q => D.quantities[q]?.[units]?.[1] ?? 1, unit = q => D.quantities[q]?.[units]?.[0] ?? q', &
      'const row_at = ({d}, depth) => Math.max(0, Math.min(d.findLastIndex(place => place <= depth), d.length - 2))', &
      'const rounding = .01', &
      'const reaches = ({d}, depth) => depth >= d[0] - rounding && depth <= d[d.length - 1] + rounding', &
      'function value_in(c, depth) {', &
      'if (!c || !reaches(c, depth)) return NaN', &
      'const i = row_at(c, depth), part = (depth - c.d[i]) / (c.d[i + 1] - c.d[i]) || 0', &
      'if (c.words) return c.v[part < .5 ? i : i + 1]', &
      'if (part === 0 || part === 1) return c.v[i + part]', &
      'if (c.inverse) return 1 / ((1 - part) / c.v[i] + part / c.v[i + 1])', &
      'const step = c.v[i + 1] - c.v[i]', &
      'return c.turns ? (c.v[i] + part * ((step + 540) % 360 - 180) + 360) % 360 : c.v[i] + part * step', &
      '}', &
      'const value_at = (p, name, depth) => value_in(p.curves[name], depth)', &
      'const is_held = (p, name, depth) => name === ''gap_state'' && p.held && depth >= D.cases[p.case].depth - round'// &
      'ing', &
      'const word_at = (p, name, depth) => is_held(p, name, depth) ? ''held'' : D.columns[name].words[value_at(p, nam'// &
      'e, depth)] ?? ''\u2013''', &
      'function text_of(value, q) {', &
      'if (!isFinite(value)) return ''\u2013''', &
      'const v = value * factor(q), a = Math.abs(v)', &
      'const text = v.toFixed(a >= 1000 ? +(q === ''length'') : a >= 100 ? 1 : a >= 10 ? 2 : 3)', &
      'return +text ? text : text.replace(''-'', '''')', &
      '}', &
      'const depth_of_units = depth => +(depth * factor(''length'')).toFixed(2)', &
      'const over = n => D.columns?.[n]?.over ? `, ${depth_text(D.columns[n].over)}` : ''''', &
      'const depth_text = depth => `${depth_of_units(depth)} ${unit(''length'')}`', &
      'function make(parent, tag, attributes, text) {', &
      'const svg = ''http://www.w3.org/2000/svg''', &
      'const e = tag.startsWith(''h:'') ? document.createElement(tag.slice(2)) : document.createElementNS(svg, tag)', &
      'for (const k in attributes) {', &
      'if (k.startsWith(''on'')) e.addEventListener(k.slice(2), attributes[k]); else e.setAttribute(k, attributes[k])', &
      '}', &
      'if (text !== undefined) e.textContent = text', &
      'parent?.append(e)', &
      'return e', &
      '}', &
      'function ticks(low, high, most) {', &
      'const raw = (high - low) / most, power = 10 ** Math.floor(Math.log10(raw))', &
      'const step = power * [1, 2, 5, 10].find(f => f * power >= raw)', &
      'const from = Math.ceil(low / step - 1e-9), to = Math.floor(high / step + 1e-9)', &
      'return Array.from({length: Math.max(0, to - from + 1)}, (_, i) => +((from + i) * step).toPrecision(12))', &
      '}', &
      'function draw_marks(parent, places, {mark, look: {stroke}}) {', &
      'const d = places.map(place => place + shapes[mark < 4 ? mark - 1 : (mark >> 1) + 1]).join('''')', &
      'if (mark) make(parent, ''path'', {d, ''stroke-width'': 1.6, fill: mark > 4 && mark % 2 ? stroke : ''none'', st'// &
      'roke})', &
      '}', &
      'function draw_key(parent, key) {', &
      'const svg = make(parent, ''svg'', {viewBox: ''0 -4 44 16'', class: ''key''})', &
      'if (!key.marks) make(svg, ''line'', {x1: 0, x2: 44, y1: 4, y2: 4, ''stroke-width'': 3, ...key.look})', &
      'draw_marks(svg, [''M22 4''], key)', &
      '}', &
      'function block(S, address) {', &
      'const state = {case: [choices.case[D.start]], model: choices.model, chart: 0, depth: undefined, hidden: new Se'// &
      't()}', &
      'Object.assign(state, {tint: ''side_force_on_joint'', yaw: -0.6, pitch: 0.35})', &
      'const depths = () => D.cases.map(c => state.case.includes(c.name) ? c.depth : 0)', &
      'const end_of = () => S.rows ? S.rows.length + .6 : S.end ?? (Math.max(...depths()) || D.cases[D.start].depth)', &
      'const first = state.top = S.rows ? .4 : S.begin ?? 0, view = {}, up = 30, down = 26', &
      'let H', &
      'const y_of = depth => up + (depth - state.top) / (state.bottom - state.top) * (H - up - down)', &
      'const depth_of = y => state.top + (y - up) / (H - up - down) * (state.bottom - state.top)', &
      'const place_text = () => S.rows ? S.rows[state.depth - 1] : depth_text(state.depth)', &
      'const zoom = (top, bottom) => { Object.assign(state, {top, bottom}); draw() }, whole = () => zoom(first, end_o'// &
      'f())', &
      'const first_sheet = () => paper && S.charts[1] && !state.chart', &
      'const panels_of = () => S.panels ?? S.charts[first_sheet() ? 1 : state.chart].panels', &
      'const chosen = p => state.case.includes(D.cases[p.case].name) && state.model.includes(p.model)']
   character(169), parameter :: script_lines_2(100) = [character(169) :: &
      'function key_of(p) {', &
      'const cases = [...new Set(D.profiles.filter(chosen).map(({case: c}) => c))], n = cases.indexOf(p.case), most ='// &
      ' D.looks.length', &
      'if (cases.length < 2) return p.key', &
      'return {...p.key, mark: D.looks[(n + Math.floor(n / most)) % most].mark, look: {...p.key.look, ...D.looks[n % '// &
      'most].look}}', &
      '}', &
      'const lines_of = panel => S.charts ? panel.lines.filter(l => chosen(l.profile)).map(l => ({...key_of(l.profile'// &
      '), ...l})) : panel.lines', &
      'const visible = line => !line.keys.some(k => state.hidden.has(k))', &
      'const shown = () => D.profiles.filter((p, k) => chosen(p) && !state.hidden.has(k))', &
      'function row_beside({curve: {d, v}}) {', &
      'const far = i => Math.abs(d[i] - state.depth), near = S.rows ? .5 : 6 / (H - up - down) * (state.bottom - stat'// &
      'e.top)', &
      'return [...d.keys()].filter(i => isFinite(v[i]) && far(i) <= near).sort((a, b) => far(a) - far(b))[0] ?? -1', &
      '}', &
      'function text_at(line, q) {', &
      'if (line.edge) return ''''', &
      'const i = line.marks ? row_beside(line) : -1, v = line.marks ? line.curve.v[i] : value_in(line.curve, state.de'// &
      'pth)', &
      'return text_of(v, q) + (line.low?.[i] === undefined ? '''' : ` (${text_of(line.low[i], q)} to ${text_of(line.h'// &
      'igh[i], q)})`)', &
      '}', &
      'function seen_of(line) {', &
      'const {curve: {d, v}} = line, from = row_at(line.curve, state.top), to = row_at(line.curve, state.bottom) + 2', &
      'return line.marks ? {d, v} : {d: d.subarray(from, to), v: v.subarray(from, to)}', &
      '}', &
      'function path_of({d, v}, x_of, turns) {', &
      'const apart = i => !isFinite(v[i - 1]) || (turns && Math.abs(v[i] - v[i - 1]) > 180)', &
      'const place = i => x_of(v[i]).toFixed(1) + '' '' + y_of(d[i]).toFixed(1)', &
      'return [...d.keys()].filter(i => isFinite(v[i])).map(i => (apart(i) ? `M${place(i)}h0` : ''L'' + place(i))).jo'// &
      'in('''')', &
      '}', &
      'function range_of(panel, lines) {', &
      'if (panel.high !== undefined) return [panel.low, panel.high]', &
      'const all = lines.filter(l => !l.loose).flatMap(l => [...l.seen.v, ...(l.low ?? []), ...(l.high ?? [])])', &
      'const known = [...(S.charts ? [0] : []), ...all.filter(v => isFinite(v))]', &
      'const least = known.reduce((a, b) => Math.min(a, b), panel.low ?? known[0] ?? 0)', &
      'const most = known.reduce((a, b) => Math.max(a, b), least), air = Math.max((most - least) * .05, Math.abs(most'// &
      ') * .01) || 1', &
      'return [least === (panel.low ?? 0) ? least : least - air, Math.min(most + air, panel.most ?? Infinity)]', &
      '}', &
      'function draw_axis(svg, left, right, first_of_row) {', &
      'const length = factor(''length''), depths = S.rows ? [] : ticks(state.top * length, state.bottom * length, H /'// &
      ' 47)', &
      'if (first_of_row && !S.rows) make(svg, ''text'', {x: left - 4, y: 12, ''text-anchor'': ''end''}, `MD [${unit('''// &
      'length'')}]`)', &
      'for (const [at, name] of S.rows?.map((name, i) => [i + 1, name]) ?? depths.map(t => [t / length, String(t)])) '// &
      '{', &
      'const y = y_of(at), most = Math.floor((left - 6) / 6.4)', &
      'const short = name.length > most ? name.slice(0, most - 1) + ''\u2026'' : name', &
      'make(svg, ''line'', {x1: left, x2: right, y1: y, y2: y, class: ''grid''})', &
      'if (first_of_row) make(make(svg, ''text'', {x: left - 4, y: y + 4, ''text-anchor'': ''end''}, short), ''title'''// &
      ', {}, name)', &
      '}', &
      '}', &
      'function draw_line(clip, marks, line, x) {', &
      'const {look, curve} = line', &
      'if (line.low) {', &
      'const d = [...curve.d].map((d, i) => `M${x(line.low[i])} ${y_of(d)}H${x(line.high[i])}`).join('''')', &
      'make(clip, ''path'', {d, stroke: look.stroke, ''stroke-width'': line.thick ? 14 : 2})', &
      'if (!line.thick) return', &
      '} else if (!line.marks) {', &
      'const d = path_of(line.seen, x, curve.turns)', &
      'make(clip, ''path'', {d, fill: ''none'', ''stroke-width'': 1.7, ''stroke-linecap'': ''round'', ...look})', &
      '}', &
      'const at = Array.from({length: 8}, (_, i) => state.top + (i + .5) / 8 * (state.bottom - state.top))', &
      'const {d, v} = line.marks ? curve : {d: at, v: at.map(d => value_in(curve, d))}', &
      'const there = [...d.keys()].filter(i => isFinite(v[i]) && d[i] >= state.top && d[i] <= state.bottom)', &
      'draw_marks(marks, there.map(i => `M${x(v[i]).toFixed(1)} ${y_of(d[i]).toFixed(1)}`), line)', &
      '}', &
      'function draw_panel(panel, index, width) {', &
      'const svg = make(null, ''svg'', {viewBox: `0 0 ${width} ${H}`, role: ''img'', ''aria-label'': panel.label, cla'// &
      'ss: ''panel''})', &
      'const names = S.rows && Math.min(.4 * width, 12 + 6.4 * Math.max(...S.rows.map(n => n.length)))', &
      'const left = index ? 12 : names ?? 46, right = width - 16', &
      'const lines = lines_of(panel).filter(visible).map(l => ({...l, seen: seen_of(l)})), q = panel.quantity, f = fa'// &
      'ctor(q)', &
      'const [low, high] = range_of(panel, lines).map(v => v * f)', &
      'const x_of = v => left + (v * f - low) / (high - low) * (right - left)', &
      'const inside = more => {', &
      'const place = {x: left - more, y: up - more, width: right - left + 2 * more, height: H - up - down + 2 * more}', &
      'make(make(svg, ''clipPath'', {id: ''clip'' + ++clips}), ''rect'', place)', &
      'return make(svg, ''g'', {''clip-path'': `url(#clip${clips})`})', &
      '}', &
      'for (const t of panel.ticks ?? ticks(low, high, Math.max(3, (right - left) / 50))) {', &
      'const x = x_of(t / f)', &
      'make(svg, ''line'', {x1: x, x2: x, y1: up, y2: H - down, class: t ? ''grid'' : ''zero''})', &
      'make(svg, ''text'', {x, y: H - down + 15, ''text-anchor'': ''middle''}, t)', &
      '}', &
      'draw_axis(svg, left, right, !index)', &
      'make(svg, ''rect'', {x: left, y: up, width: right - left, height: H - up - down, class: ''frame''})', &
      'const words = make(make(svg, ''foreignObject'', {x: left, y: 0, width: right - left, height: up}), ''h:div'', '// &
      '{})', &
      'make(words, ''h:b'', {}, panel.label + over(panel.curves?.[0].column) + '' '')', &
      'if (unit(q)) words.append(`[${unit(q)}]`)', &
      'const curves = inside(0), marks = inside(6)', &
      'for (const line of lines) draw_line(curves, marks, line, line.edge ? () => left : x_of)', &
      'make(svg, ''line'', {x1: left, x2: right, y1: 0, y2: 0, class: ''cross''})', &
      'make(svg, ''rect'', {x: left, width: right - left, class: ''band''})', &
      'return svg', &
      '}', &
      'function draw_panels() {', &
      'const panels = panels_of().filter(p => !paper || !S.charts || lines_of(p).some(l => l.curve.v.some(v => v))), '// &
      'bare = !panels.flatMap(lines_of).length', &
      'const none = ''No curves: choose a load case that has a solution. Answers and warnings above say why others ha'// &
      've none.''', &
      'S.root.classList.toggle(''bare'', bare)', &
      'const wide = paper ? paper.wide / (S.halved ? 2 : 1) : view.panels.clientWidth || 1000', &
      'const abreast = Math.min(panels.length, wide >= 600 ? Infinity : S.rows ? 1 : 2)', &
      'const one = (panel, i) => draw_panel(panel, i % abreast, Math.max(150, wide / abreast))', &
      'view.panels.replaceChildren(...(bare ? [none] : panels.map(one)))', &
      'for (const s of view.panels.children) s.style.width = 100 / abreast + ''%''', &
      'set_depth(state.depth)', &
      '}', &
      'function set_depth(depth) {', &
      'if (depth !== state.depth) view.notice.textContent = ''''']
   character(169), parameter :: script_lines_3(100) = [character(169) :: &
      'view.slider.value = depth', &
      'state.depth = +view.slider.value', &
      'if (view.typed) view.typed.value = depth_of_units(state.depth)', &
      'view.panels.style.setProperty(''--cross'', y_of(state.depth) + ''px'')', &
      'view.well?.mark()', &
      'draw_readout()', &
      'note_address()', &
      '}', &
      'function cells_of_profiles() {', &
      'const list = shown(), wanted = panels_of().flatMap(p => p.curves.map(c => c.column))', &
      'const known = Object.keys(D.columns).filter(n => list.some(p => p.curves[n]))', &
      'const names = view.all.checked ? known : [...new Set(wanted)]', &
      'const by_model = state.case.length === 2 ? state.model.map(m => list.filter(p => p.model === m)) : []', &
      'const pairs = list.length === 2 ? [list] : by_model.filter(pair => pair.length === 2)', &
      'const heads = pairs.map(([a, b]) => `${b.key.text} less ${a.key.text}`)', &
      'const above = p => D.cases[p.case].depth - state.depth', &
      'const there = p => D.cases[p.case].parts.find(({from, to}) => from <= above(p) && above(p) <= to)', &
      'const row_of = n => {', &
      'const {label, quantity, words, inverse} = D.columns[n], at = p => value_at(p, n, state.depth)', &
      'const band = p => (p.bands?.[n] ?? 0) * (inverse ? at(p) ** 2 : 1) * factor(quantity)', &
      'const told = (value, b) => text_of(value, quantity) + (b > 0 ? ` \u00b1${+b.toPrecision(2)}` : '''')', &
      'return [label + over(n), unit(quantity), ...list.map(p => words ? word_at(p, n, state.depth) : told(at(p), ban'// &
      'd(p))),', &
      '...pairs.map(([a, b]) => words ? '''' : told(at(b) - at(a), band(a) + band(b)))]', &
      '}', &
      'return [', &
      '[''quantity'', ''unit'', ...list.map(p => p.key.text), ...heads],', &
      '[''component'', '''', ...list.map(p => there(p)?.name ?? ''\u2013''), ...pairs.map(() => '''')],', &
      '...names.map(row_of)', &
      ']', &
      '}', &
      'function cells_of_lines() {', &
      'const panels = panels_of(), lines = panels.map(p => lines_of(p).filter(visible))', &
      'const near = lines.flat().filter(l => l.marks ? row_beside(l) >= 0 : reaches(l.curve, state.depth))', &
      'const heads = panels.map(p => p.label + (unit(p.quantity) ? ` [${unit(p.quantity)}]` : ''''))', &
      'const texts = (name, k) => lines[k].filter(l => l.name === name).map(l => text_at(l, panels[k].quantity))', &
      'const within = (few, many) => few.length === many.length - 1 && few.every(k => many.includes(k))', &
      'const under = mark => lines.flat().find(l => mark.marks && !l.marks && within(l.keys, mark.keys))', &
      'const bases = new Map(near.filter(under).map(mark => [mark.name, under(mark).name]))', &
      'const names = [...new Set(near.map(l => l.name))].filter(name => ![...bases.values()].includes(name))', &
      'const text_of_name = (name, k) => texts(bases.get(name) ?? name, k).find(text => text !== ''\u2013'') ?? ''\u2'// &
      '013''', &
      'return [[''curve'', ...heads], ...names.map(name => [name, ...panels.map((_, k) => text_of_name(name, k))])]', &
      '}', &
      'function draw_readout() {', &
      'const table = make(null, ''h:table'', {}), rows = S.charts ? cells_of_profiles() : cells_of_lines()', &
      'make(table, ''h:caption'', {}, S.rows ? place_text() : `At ${place_text()} ${S.over}`)', &
      'rows.forEach((row, k) => {', &
      'const line = make(table, ''h:tr'', {})', &
      'row.forEach((text, i) => make(line, k ? ''h:td'' : ''h:th'', {class: i ? '''' : ''text'', title: meanings[text'// &
      '.split('', '')[0]] ?? ''''}, text))', &
      '})', &
      'view.readout.replaceChildren(table)', &
      'view.slider.setAttribute(''aria-valuetext'', [place_text(), ...rows.map(row => row.join('' ''))].join('', ''))', &
      '}', &
      'function draw() {', &
      'H = S.rows ? 64 + (paper ? 15 : 24) * S.rows.length : paper?.high ?? 420', &
      'if (!(state.bottom > state.top) || state.bottom > end_of()) Object.assign(state, {top: first, bottom: end_of()'// &
      '})', &
      'Object.assign(view.slider, S.rows ? {min: 1, max: S.rows.length} : {min: state.top, max: state.bottom})', &
      'if (view.typed) view.typed.previousSibling.textContent = `${S.over} [${unit(''length'')}] `', &
      'draw_legend()', &
      'draw_panels()', &
      'view.well?.draw()', &
      '}', &
      'function add_list(parent, key, text) {', &
      'const more = {multiple: '''', size: Math.min(1 + choices[key].length, 16)}', &
      'const list = make(make(parent, ''h:label'', {}, text), ''h:select'', more)', &
      'for (const name of choices[key]) make(list, ''h:option'', {}, name).selected = state[key].includes(name)', &
      'list.onchange = () => { state[key] = [...list.selectedOptions].map(o => o.value); draw() }', &
      '}', &
      'function draw_legend() {', &
      'const used = new Set(panels_of().flatMap(lines_of).flatMap(l => l.keys))', &
      'view.legend.replaceChildren()', &
      'S.keys.forEach((key, id) => {', &
      'if (key.words) make(view.legend, ''h:span'', {}, key.text)', &
      'if (key.words || !used.has(id)) return', &
      'const turn = () => { if (!state.hidden.delete(id)) state.hidden.add(id); draw() }', &
      'const b = make(view.legend, ''h:button'', {type: ''button'', ''aria-pressed'': !state.hidden.has(id), onclick:'// &
      ' turn})', &
      'draw_key(b, S.charts ? key_of(D.profiles[id]) : key)', &
      'b.append(key.text)', &
      '})', &
      '}', &
      'function go_to(depth) {', &
      'if (depth < state.top || depth > state.bottom) whole()', &
      'set_depth(isNaN(depth) ? state.depth : depth)', &
      '}', &
      'function listen() {', &
      'let from, pinch, wanted', &
      'const y_in = ({target, clientY}) => {', &
      'const place = target.closest(''svg.panel'')?.getBoundingClientRect()', &
      'return place ? (clientY - place.top) / place.height * H : NaN', &
      '}', &
      'const want = (top, bottom) => {', &
      'wanted = [Math.max(first, top), Math.min(end_of(), bottom)]', &
      'view.panels.style.setProperty(''--band'', y_of(wanted[0]) + ''px'')', &
      'view.panels.style.setProperty(''--bands'', Math.max(0, y_of(wanted[1]) - y_of(wanted[0])) + ''px'')', &
      '}', &
      'const point = e => {', &
      'const y = y_in(e)', &
      'if (isNaN(y)) return', &
      'if (e.type === ''pointerdown'' && e.pointerType === ''mouse'' && !S.rows) from = y', &
      'set_depth(depth_of(y))', &
      'if (Math.abs(y - from) > 6) want(depth_of(Math.min(from, y)), depth_of(Math.max(from, y)))']
   character(169), parameter :: script_lines_4(100) = [character(169) :: &
      '}', &
      'const spread = e => {', &
      'if (e.touches.length !== 2 || S.rows) return', &
      'e.preventDefault()', &
      'const [a, b] = [...e.touches].map(y_in).sort((a, b) => a - b)', &
      'pinch ??= [depth_of(a), depth_of(b)]', &
      'const step = (pinch[1] - pinch[0]) / Math.max(b - a, 20), top = Math.max(0, pinch[0] - step * (a - up))', &
      'want(top, top + step * (H - up - down))', &
      '}', &
      'const finish = () => {', &
      'if (wanted?.[1] > wanted?.[0]) zoom(...wanted)', &
      'view.panels.style.removeProperty(''--bands'')', &
      'from = pinch = wanted = undefined', &
      '}', &
      'for (const kind of [''pointerdown'', ''pointermove'']) view.panels.addEventListener(kind, point)', &
      'for (const kind of [''touchstart'', ''touchmove'']) view.panels.addEventListener(kind, spread, {passive: false'// &
      '})', &
      'for (const kind of [''pointerup'', ''touchend'']) addEventListener(kind, finish)', &
      '}', &
      'function note_address() {', &
      'if (active !== S) return', &
      'clearTimeout(noting)', &
      'noting = setTimeout(() => {', &
      'const q = new URLSearchParams(S.charts ? state.case.map(name => [''case'', name]) : [])', &
      'if (S.charts && state.model.length < choices.model.length) for (const name of state.model) q.append(''model'','// &
      ' name)', &
      'q.set(''chart'', S.title ?? S.charts[state.chart].title)', &
      'const zoomed = state.top > first || state.bottom < end_of()', &
      'for (const k of zoomed ? [''depth'', ''top'', ''bottom''] : [''depth'']) q.set(k, +state[k].toFixed(3))', &
      'if (units !== D.units) q.set(''units'', units)', &
      'history.replaceState(null, '''', ''#'' + q)', &
      '}, 300)', &
      '}', &
      'for (const k of [''case'', ''model'']) if (address.has(k)) state[k] = address.getAll(k)', &
      'state.chart = Math.max(0, S.charts?.findIndex(c => c.title === address.get(''chart'')) ?? 0)', &
      'for (const k of [''depth'', ''top'', ''bottom'']) if (isFinite(parseFloat(address.get(k)))) state[k] = parseFl'// &
      'oat(address.get(k))', &
      'S.root.replaceChildren()', &
      'const bar = make(S.root, ''h:div'', {class: ''bar''})', &
      'const button = (text, onclick, more) => make(bar, ''h:button'', {type: ''button'', onclick, ...more}, text)', &
      'const choose = i => {', &
      'state.chart = i', &
      'bar.querySelectorAll(''.tab'').forEach((o, k) => o.setAttribute(''aria-pressed'', k === i))', &
      'draw()', &
      '}', &
      'S.charts?.forEach((c, i) => button(c.title, () => choose(i), {''aria-pressed'': i === state.chart, class: ''ta'// &
      'b''}))', &
      'add_switch(bar)', &
      'if (!S.rows) button(''whole depth'', whole)', &
      'if (S.charts) button(lowest(), () => zoom(Math.max(0, end_of() - shown_length), end_of()))', &
      'const main = make(S.root, ''h:div'', {class: S.charts ? ''main'' : ''alone''})', &
      'if (S.charts) {', &
      'const side = make(main, ''h:div'', {class: ''side''})', &
      'add_list(side, ''case'', ''Load cases, several with Ctrl'')', &
      'if (choices.model.length > 1) add_list(side, ''model'', ''Models'')', &
      '}', &
      'const right = make(main, ''h:div'', {class: ''right''})', &
      'view.notice = make(right, ''h:p'', {class: ''notice''})', &
      'view.legend = make(right, ''h:div'', {class: ''legend''})', &
      'view.panels = make(right, ''h:div'', {class: ''panels''})', &
      'const slide = {''aria-label'': S.over ?? ''row'', oninput: e => set_depth(+e.target.value)}', &
      'view.slider = make(right, ''h:input'', {type: ''range'', step: S.rows ? 1 : ''any'', ...slide})', &
      'if (!S.rows) {', &
      'const type = {type: ''number'', step: ''any'', min: 0, onchange: e => go_to(e.target.valueAsNumber / factor('''// &
      'length''))}', &
      'view.typed = make(make(right, ''h:label'', {class: ''typed''}, '' ''), ''h:input'', type)', &
      '}', &
      'view.readout = make(right, ''h:div'', {class: ''wide readout'', tabindex: 0})', &
      'if (S.charts) {', &
      'const label = make(right, ''h:label'', {})', &
      'view.all = make(label, ''h:input'', {type: ''checkbox'', onchange: draw_readout})', &
      'label.append('' all columns'')', &
      'view.well = well_figures({root: S.root, state, shown, key_of, place_text, set_depth})', &
      '}', &
      'listen()', &
      'view.panels.addEventListener(''dblclick'', whole)', &
      'for (const kind of [''pointerenter'', ''focusin'']) S.root.addEventListener(kind, () => active = S)', &
      'state.bottom ??= end_of()', &
      'const known = ({curve: {d, v}}) => [...d].filter((_, i) => isFinite(v[i]))', &
      'const first_row = () => Math.round(Math.min(...S.panels.flatMap(p => p.lines).filter(l => l.marks).flatMap(kno'// &
      'wn)))', &
      'state.depth ??= S.rows ? first_row() : S.end ?? state.bottom / 2', &
      'const unknown = (k, what) => state[k].filter(name => !choices[k].includes(name)).map(name => `No ${what} is na'// &
      'med ''${name}''.`)', &
      'const names = S.charts ? [...unknown(''case'', ''load case''), ...unknown(''model'', ''model'')] : []', &
      'const deep = !S.rows && state.depth > end_of() + rounding ? [`The address asks for ${depth_text(state.depth)}.'// &
      ' The chart ends at ${depth_text(end_of())}.`] : []', &
      'view.notice.textContent = [...names, ...deep].join('' '')', &
      'return {S, state, draw}', &
      '}', &
      'function add_switch(parent) {', &
      'const turn = () => { units = D.systems[(D.systems.indexOf(units) + 1) % D.systems.length]; draw_all() }', &
      'make(parent, ''h:button'', {type: ''button'', class: ''units'', onclick: turn})', &
      '}', &
      'function draw_all() {', &
      'for (const b of blocks) b.draw()', &
      'for (const head of document.querySelectorAll(''th[data-q]'')) {', &
      'const {q, digits} = head.dataset', &
      'head.querySelector(''small'').textContent = unit(q)', &
      'for (const {cells: {[head.cellIndex]: cell}} of head.closest(''table'').tBodies[0].rows) {', &
      'const own = cell.dataset.own ??= cell.textContent, value = (cell.dataset.v ?? own) * factor(q)', &
      'const text = digits ? String(+value.toPrecision(digits)) : value.toFixed(own.split(''.'')[1]?.length ?? 0)', &
      'cell.textContent = units === D.units || own === '''' || isNaN(value) ? own : text', &
      '}', &
      '}', &
      'for (const e of document.querySelectorAll(''[data-si],[data-field],[data-metric]'')) {', &
      'const own = e.dataset.own ??= e.textContent', &
      'e.textContent = e.dataset[units.toLowerCase()] ?? own']
   character(169), parameter :: script_lines_5(100) = [character(169) :: &
      '}', &
      'document.querySelector(''.switched'').hidden = units === D.units', &
      'for (const b of document.querySelectorAll(''.units'')) b.textContent = ''units: '' + units', &
      '}', &
      'function follow_address() {', &
      'const q = new URLSearchParams(location.hash.slice(1))', &
      'if (D.systems.includes(q.get(''units''))) units = q.get(''units'')', &
      'active = parts.find(S => S.title && S.title === q.get(''chart'')) ?? parts[0]', &
      'parts.forEach((S, i) => { if (S === active || !blocks[i]) blocks[i] = block(S, S === active ? q : new URLSearc'// &
      'hParams()) })', &
      'draw_all()', &
      'if (q.size) active.root.scrollIntoView()', &
      '}', &
      'addEventListener(''hashchange'', follow_address)', &
      'addEventListener(''resize'', draw_all)', &
      'const draw_for = size => { paper = size; draw_all() }', &
      'function write_depths(p) {', &
      'const place = document.querySelector(''.depths''), f = factor(''length''), end = D.cases[p.case].depth', &
      'const known = [''axial'', ''torque'', ''side_force_on_joint'', ''bending'', ''displacement'', ''von_mises'', '''// &
      'safety_factor'', ''buckling_margin'']', &
      'const names = known.filter(n => p.curves[n]?.v.some(v => v)), quantity = n => D.columns[n].quantity', &
      'const heads = [''measured depth'', ...names.map(n => D.columns[n].label + over(n))]', &
      'const units_of = [unit(''length''), ...names.map(n => unit(quantity(n)))]', &
      'place.replaceChildren()', &
      'make(place, ''h:h2'', {}, ''Along the string: '' + p.key.text)', &
      'const table = make(place, ''h:table'', {}), head = make(make(table, ''h:thead'', {}), ''h:tr'', {}), body = ma'// &
      'ke(table, ''h:tbody'', {})', &
      'heads.forEach((text, i) => make(head, ''h:th'', {}, text + (units_of[i] ? ` [${units_of[i]}]` : '''')))', &
      'for (const depth of [...ticks(0, end * f, 18).map(t => t / f).filter(d => d < end), end]) {', &
      'const row = make(body, ''h:tr'', {}), texts = names.map(n => text_of(value_at(p, n, depth), quantity(n)))', &
      'for (const text of [depth_of_units(depth), ...texts]) make(row, ''h:td'', {}, text)', &
      '}', &
      '}', &
      'const folded = []', &
      'addEventListener(''afterprint'', () => {', &
      'for (const part of folded.splice(0)) part.open = false', &
      'draw_for(null)', &
      '})', &
      'addEventListener(''beforeprint'', () => {', &
      'if (D.profiles) {', &
      'paper = {wide: 660, high: 300}', &
      'const root = make(null, ''h:div'', {}), charts = [{panels: D.charts[0].panels.slice(0, 4)}], {state} = blocks['// &
      '0]', &
      'const solved = D.profiles.some(p => state.case.includes(D.cases[p.case].name) && state.model.includes(p.model)'// &
      ')', &
      'const view = [''case'', ''model''].flatMap(k => state[k].map(name => [k, name]))', &
      'block({root, keys: D.profiles.map(p => p.key), charts}, new URLSearchParams(solved ? view : [])).draw()', &
      'document.querySelector(''.first'').replaceChildren(...root.querySelectorAll(''.legend, .panels''))', &
      'const chosen = p => state.case.includes(D.cases[p.case].name) && state.model.includes(p.model)', &
      'write_depths(D.profiles.find(chosen) ?? D.profiles.find(p => p.case === D.start))', &
      '}', &
      'for (const part of document.querySelectorAll(''.on-paper:not([open])'')) {', &
      'folded.push(part)', &
      'part.open = true', &
      '}', &
      'draw_for({wide: 1100, high: 260})', &
      '})', &
      'const places = [...document.querySelectorAll(''.live:not(.first)'')]', &
      'const root_in = place => make(place, ''h:div'', {})', &
      'const string = () => ({charts: D.charts, keys: D.profiles.map(p => p.key), over: ''measured depth'', root: roo'// &
      't_in(places.shift())})', &
      'const along = D.profiles ? [string()] : []', &
      'const title_of = (f, i) => f.title + (i ? ` (${i + 1})` : '''')', &
      'const of_figure = (f, place) => f.blocks.map((b, i) => ({', &
      '...b, keys: f.keys, title: title_of(f, i), root: root_in(place), halved: f.blocks.length > 1', &
      '}))', &
      'const parts = [...along, ...D.figures.flatMap((f, i) => of_figure(f, places[i]))]', &
      'document.querySelector(''.hint'').append(` Curves are thinned to ${D.thinned} of their range, safety factors b'// &
      'y their inverse.${D.reduced} The CSV files have all points.`)', &
      'add_switch(document.querySelector(''h1 + p''))', &
      'follow_address()', &
      'document.documentElement.classList.add(''scripted'')', &
      'if (location.hash) active.root.scrollIntoView()', &
      'function level_of(code) {', &
      'return code - 35 - (code > 60) - (code > 92)', &
      '}', &
      'function depths_of(text) {', &
      'const d = []', &
      'for (let i = 0, sum = 0, step = 0, n = 0; i < text.length; i++) {', &
      'const digit = level_of(text.charCodeAt(i))', &
      'n = n * 45 + digit % 45', &
      'if (digit < 45) { d.push((sum += step += n % 2 ? -(n + 1) / 2 : n / 2) / 1000); n = 0 }', &
      '}', &
      'return Float64Array.from(d)', &
      '}', &
      'function group_of(levels) {', &
      'let length = 1, number = 0', &
      'for (let i = 1; i <= 8; i++) {', &
      'let n = 0', &
      'for (let power = levels; power <= 90 ** i; power *= levels) n++', &
      'if (n * length > number * i) [length, number] = [i, n]', &
      '}', &
      'return [length, number]', &
      '}', &
      'function values_of(text, first, step, count, levels) {', &
      'const v = new Float64Array(count), [length, number] = levels ? group_of(levels) : [text.length / count, 1], al'// &
      'l = levels ?? 90 ** length', &
      'for (let i = 0; i < count; i += number) {', &
      'const at = i / number * length', &
      'let group = 0', &
      'for (let k = at; k < at + length; k++) group = group * 90 + level_of(text.charCodeAt(k))', &
      'for (let k = i + number - 1; k >= i; k--) {', &
      'const level = group % all', &
      'group = (group - level) / all', &
      'if (k < count) v[k] = levels || length < 4 ? (first + level) * step : (Math.floor(level / 90) - 364500) * 10 *'// &
      '* (level % 90 - 45)', &
      'if (k < count && level === all - 1) v[k] = NaN', &
      '}', &
      '}']
   character(169), parameter :: script_lines_6(100) = [character(169) :: &
      'return v', &
      '}', &
      'function curve_of(written, rows) {', &
      'const [first, step, depths, values, levels] = written ?? [0, 1, '''', '''']', &
      'const even = ([from, to, n]) => Float64Array.from({length: n + 1}, (_, i) => from + i / n * (to - from))', &
      'const has = (bits, i) => level_of(bits.charCodeAt(Math.floor(i / 6))) >> (5 - i % 6) & 1', &
      'const places = ([text, bits]) => bits ? rows.filter((_, i) => has(bits, i)) : depths_of(text).map(i => rows[Ma'// &
      'th.round(1000 * i)])', &
      'const d = depths === 0 ? rows : typeof depths === ''string'' ? depths_of(depths) : depths.length < 3 ? places('// &
      'depths) : even(depths)', &
      'return {d, v: values_of(values, first, step, d.length, levels)}', &
      '}', &
      'function inverse_of({d, v}) {', &
      'const at = [], made = []', &
      'for (let i = 0; i < d.length; i++) {', &
      'const ratio = v[i] > 0 && v[i - 1] > 0 ? v[i - 1] / v[i] : 1, steps = Math.ceil(10 * Math.abs(Math.log(ratio))'// &
      ') || 1', &
      'for (let k = steps - 1; k >= 0; k--) {', &
      'const there = v[i] * ratio ** (k / steps), part = k && (there - v[i]) / (v[i - 1] - v[i])', &
      'at.push(part ? d[i] + part * (d[i - 1] - d[i]) : d[i])', &
      'made.push(there > 0 ? 1 / there : NaN)', &
      '}', &
      '}', &
      'return {d: Float64Array.from(at), v: Float64Array.from(made), inverse: true}', &
      '}', &
      'function well_figures(b) {', &
      'const {root, state, shown} = b', &
      'const angle = (p, d) => {', &
      'const {clock} = p.curves, i = row_at(clock, d), off = k => value_at(p, ''displacement'', clock.d[k]) > 0', &
      'return (off(i) && off(i + 1) ? value_at(p, ''clock'', d) : clock.v[off(i) ? i : i + 1]) * Math.PI / 180', &
      '}', &
      'const leading = () => shown().find(p => p.contacts) ?? shown()[0]', &
      'const lower = make(root, ''h:div'', {class: ''lower''})', &
      'const picture = (parent, label, more) => make(make(parent, ''h:figure'', {}), ''svg'', {role: ''img'', ''aria-'// &
      'label'': label, ...more})', &
      'const section = picture(lower, ''string in the hole at this depth'', {viewBox: ''0 -6 200 214''})', &
      'const well = picture(lower, ''the well in three dimensions'', {viewBox: ''0 0 460 440'', tabindex: 0})', &
      'const assembly = picture(root, ''lowest part of the string in the hole''), scale = make(assembly.parentNode, '''// &
      'h:figcaption'', {})', &
      'const pick = make(null, ''h:select'', {''aria-label'': ''colour of the well'', onchange: () => { state.tint = '// &
      'pick.value; draw() }})', &
      'const colour = part => `hsl(${230 - 225 * Math.min(part, 1)} 75% 48%)`', &
      'let marks = []', &
      'function writer(svg, width) {', &
      'const taken = []', &
      'return (x, y, text) => {', &
      'const half = 3.6 * text.length, at = Math.min(Math.max(x, half), width - half)', &
      'if (taken.some(t => Math.abs(t.y - y) < 13 && Math.abs(t.at - at) < t.half + half + 4)) return false', &
      'taken.push({at, half, y})', &
      'make(svg, ''text'', {x: at, y, ''text-anchor'': ''middle''}, text)', &
      'return true', &
      '}', &
      '}', &
      'function draw_section() {', &
      'section.replaceChildren()', &
      'make(section, ''circle'', {cx: 100, cy: 100, r: 88, class: ''wall''})', &
      'make(section, ''text'', {x: 100, y: 9, ''text-anchor'': ''middle''}, ''high side'')', &
      'make(section, ''text'', {x: 100, y: 204, ''text-anchor'': ''middle''}, ''at '' + b.place_text())', &
      'for (const p of shown().filter(p => state.depth <= D.cases[p.case].depth)) {', &
      'const scale = 88 / value_at(p, ''hole'', state.depth)', &
      'const off = value_at(p, ''displacement'', state.depth) * 2 * scale, a = angle(p, state.depth)', &
      'const circle = {cx: 100 + off * Math.sin(a), cy: 100 - off * Math.cos(a), r: value_at(p, ''od'', state.depth) '// &
      '* scale}', &
      'make(section, ''circle'', {...circle, fill: ''none'', ''stroke-width'': 2, ...b.key_of(p).look})', &
      '}', &
      '}', &
      'function draw_well() {', &
      'const p = leading(), place = d => [''east'', ''north'', ''tvd''].map(name => value_at(p, name, d))', &
      'well.replaceChildren()', &
      'if (!p) return () => {}', &
      'const end = D.cases[p.case].depth, n = 400, {label, quantity, words} = D.columns[state.tint]', &
      'const depths = Array.from({length: n + 1}, (_, i) => i / n * end)', &
      'const points = depths.map(d => ({d, at: place(d), value: value_at(p, state.tint, d)}))', &
      'const ends = [0, 1, 2].map(k => [Math.min(0, ...points.map(a => a.at[k])), Math.max(1, ...points.map(a => a.at'// &
      '[k]))])', &
      'const size = Math.max(...ends.map(e => e[1] - e[0])), middle = ends.map(e => (e[0] + e[1]) / 2)', &
      'const least = .1 * size, apart = (e, k) => (e[1] - e[0] < 2 * least ? [middle[k] - least, middle[k] + least] :'// &
      ' e)', &
      'const [[e0, e1], [n0, n1], [, z1]] = ends.map(apart), s = 290 / size', &
      'const cy = Math.cos(state.yaw), sy = Math.sin(state.yaw), cp = Math.cos(state.pitch), sp = Math.sin(state.pitc'// &
      'h)', &
      'const project = a => {', &
      'const e = a[0] - middle[0], m = a[1] - middle[1], z = a[2] - middle[2]', &
      'return [230 + s * (e * cy - m * sy), 180 + s * (z * cp - (e * sy + m * cy) * sp)]', &
      '}', &
      'const line = (a, b, look) => make(well, ''path'', {d: ''M'' + [a, b].map(project).join(''L''), ...look})', &
      'const write = writer(well, 460), sorted = points.map(a => a.value).filter(isFinite).sort((a, b) => a - b)', &
      'const low = words ? 0 : sorted[0], high = words ? words.length - 1 : sorted[Math.floor(.99 * (sorted.length - '// &
      '1))]', &
      'const beyond = sorted[sorted.length - 1] > high ? ''\u2265 '' : ''''', &
      'for (let i = 0; i < 40; i++) make(well, ''rect'', {x: 20 + 5 * i, y: 412, width: 5.5, height: 9, fill: colour('// &
      'i / 39)})', &
      'write(120, 434, words ? words.join('', '') : text_of(low, quantity) + '' to '' + beyond + text_of(high, quanti'// &
      'ty))', &
      'write(0, 406, (label + (unit(quantity) && ` [${unit(quantity)}]`) + '', '' + p.key.text).slice(0, 60))', &
      'const labels = []', &
      'const grid = (name, axis, from, to, ...edges) => {', &
      'const low = edge => project(edge.map((v, k) => (k === axis ? (from + to) / 2 : v)))[1]', &
      'const [corner, other] = edges.sort((a, b) => low(b) - low(a))', &
      'const at = (t, point) => point.map((v, k) => (k === axis ? t : v)), length = factor(''length'')', &
      'const [[x1, y1], [x2, y2]] = [from, to].map(t => project(at(t, corner)))', &
      'const few = Math.min(5, Math.round(Math.hypot(x2 - x1, y2 - y1) / 40))', &
      'if (few) for (const t of ticks(from * length, to * length, few)) {', &
      'const [x, y] = project(at(t / length, corner))', &
      'line(at(t / length, corner), at(t / length, other), {class: ''grid''})', &
      'const flat = Math.abs(x2 - x1) > Math.abs(y2 - y1), aside = x < 230 ? -30 : 30', &
      'labels.push([flat ? x : x + aside, flat ? y + 18 : y + 4, name + t])', &
      '}', &
      '}', &
      'grid('''', 2, 0, z1, [e1, n1, 0], [e0, n1, 0])', &
      'grid(''E '', 0, e0, e1, [0, n0, z1], [0, n1, z1])', &
      'grid(''N '', 1, n0, n1, [e0, 0, z1], [e1, 0, z1])', &
      'make(well, ''path'', {class: ''shadow'', d: ''M'' + points.map(a => project([a.at[0], a.at[1], z1])).join(''L'''// &
      ')})']
   character(169), parameter :: script_lines_7(84) = [character(169) :: &
      'points.slice(0, n).forEach((a, i) => {', &
      'const stroke = isFinite(a.value) ? colour((a.value - low) / (high - low || 1)) : ''#888''', &
      'line(a.at, points[i + 1].at, {stroke, ''stroke-width'': 5, ''stroke-linecap'': ''round'', ''pointer-events'': '// &
      '''none''})', &
      'line(a.at, points[i + 1].at, {class: ''near'', onpointerenter: () => b.set_depth(a.d)})', &
      '})', &
      'for (const label of labels) write(...label)', &
      'const dot = make(well, ''g'', {})', &
      'const said = () => words ? word_at(p, state.tint, state.depth) : text_of(value_at(p, state.tint, state.depth),'// &
      ' quantity)', &
      'return () => {', &
      'const [x, y] = project(place(state.depth))', &
      'dot.replaceChildren()', &
      'if (state.depth > end) return', &
      'make(dot, ''circle'', {cx: x, cy: y, r: 6, class: ''dot''})', &
      'const text = b.place_text() + '': '' + said(), half = 4 * text.length', &
      'make(dot, ''text'', {x: Math.min(Math.max(x, half), 460 - half), y: Math.max(11, y - 12), class: ''value'', '''// &
      'text-anchor'': ''middle''}, text)', &
      '}', &
      '}', &
      'function draw_assembly() {', &
      'const p = leading(), W = paper?.wide ?? Math.max(320, root.clientWidth || 1000), T = paper ? 190 : 290', &
      'assembly.replaceChildren()', &
      'if (!p) return () => {}', &
      'const bit = D.cases[p.case].depth, top = bit - shown_length, x_of = d => 10 + (d - top) / shown_length * (W - '// &
      '30)', &
      'const hole = value_at(p, ''hole'', bit), y_of = v => T / 2 - v / hole * (T - 110) / 1.2', &
      'const off = d => value_at(p, ''displacement'', d) * Math.cos(angle(p, d))', &
      'const point = (x, y) => `${x.toFixed(1)} ${y.toFixed(1)}`', &
      'const between = (from, to, n) => [...Array(n + 1).keys()].map(i => from + (to - from) * i / n)', &
      'const edge = (from, to, v_of) => between(from, to, 80).map(d => point(x_of(d), y_of(v_of(d))))', &
      'const write = writer(assembly, W), start = Math.max(top, p.curves.hole.d[0])', &
      'const said = (name, v) => `${text_of(v, D.columns[name].quantity)} ${unit(D.columns[name].quantity)}`', &
      'for (const side of [.5, -.5]) {', &
      'make(assembly, ''path'', {d: ''M'' + edge(start, bit, d => side * value_at(p, ''hole'', d)).join(''L''), class'// &
      ': ''wall''})', &
      '}', &
      'let row = 0', &
      'for (const part of D.cases[p.case].parts) {', &
      'const from = Math.max(bit - part.to, top), to = bit - part.from', &
      'if (to <= top) continue', &
      'const body = [...edge(from, to, d => off(d) + part.od / 2), ...edge(to, from, d => off(d) - part.od / 2)]', &
      'make(make(assembly, ''path'', {d: ''M'' + body.join(''L'') + ''z'', class: ''body''}), ''title'', {}, part.nam'// &
      'e)', &
      'row = Math.max(row, [0, 1, 2, 3].findIndex(k => write((x_of(from) + x_of(to)) / 2, 14 - 13 * k, part.name)))', &
      '}', &
      'assembly.setAttribute(''viewBox'', `0 ${-13 * row} ${W} ${T + 84 + 13 * row}`)', &
      'for (const t of ticks(0, shown_length * factor(''length''), W / 120)) write(x_of(bit - t / factor(''length''))'// &
      ', T - 4, String(t))', &
      'const contacts = (p.contacts ?? []).filter(c => c[0] > top && c[1] > 0).sort((a, b) => b[1] - a[1])', &
      'for (const [d, force, clock] of contacts) {', &
      'const side = Math.cos(clock * Math.PI / 180) < 0 ? -1 : 1, y2 = y_of(side * hole / 2)', &
      'const y1 = y2 - side * (8 + 20 * force / contacts[0][1])', &
      'make(assembly, ''line'', {x1: x_of(d), x2: x_of(d), y1, y2, class: ''force''})', &
      'write(x_of(d), side < 0 ? T - 24 : 36, text_of(force, ''force''))', &
      '}', &
      'const own = p.curves.bending.d.filter(d => d >= start && d <= bit)', &
      'const moments = [...new Set([...between(start, bit, 200), ...own])].sort((a, b) => a - b)', &
      '.map(d => [x_of(d), value_at(p, ''bending'', d)]).filter(([, m]) => isFinite(m))', &
      'const most = Math.max(...moments.map(([, m]) => m), 0)', &
      'const places = moments.map(([x, m]) => point(x, T + 80 - m / (most || 1) * 60))', &
      'make(assembly, ''path'', {d: ''M'' + places.join(''L''), class: ''moment''})', &
      'write(0, T + 14, ''moment, at most '' + said(''bending'', most))', &
      'const cross = make(assembly, ''path'', {class: ''cross''})', &
      'const words = `The ${lowest()}, ${p.key.text}, enlarged across the hole. Distance above the bit [${unit(''leng'// &
      'th'')}]` +', &
      '(p.contacts ? `, contact forces [${unit(''force'')}].` : ''.'')', &
      'return () => {', &
      'const there = state.depth >= top && state.depth <= bit', &
      'cross.setAttribute(''d'', there ? `M${x_of(state.depth)} 20V${T + 80}` : '''')', &
      'const values = [''bending'', ''displacement''].map(name => said(name, value_at(p, name, state.depth)))', &
      'scale.textContent = words + (there ? ` At ${b.place_text()}: moment ${values.join('', '')} off the axis.` : '''// &
      ''')', &
      '}', &
      '}', &
      'const mark = () => { for (const m of marks) m() }', &
      'const draw = () => { marks = [draw_well(), draw_assembly(), draw_section]; mark() }', &
      'for (const n in D.columns) make(pick, ''h:option'', {value: n}, D.columns[n].label)', &
      'pick.value = state.tint', &
      'well.before(pick)', &
      'const turn_by = (x, y) => { state.yaw += x; state.pitch = Math.min(1.5, Math.max(-1.5, state.pitch + y)); draw'// &
      '() }', &
      'const sides = {''3D'': [-0.6, 0.35], plan: [0, Math.PI / 2], ''from south'': [0, 0], ''from east'': [-Math.PI '// &
      '/ 2, 0]}', &
      'for (const name in sides) {', &
      'const turn = () => { [state.yaw, state.pitch] = sides[name]; draw() }', &
      'well.before(make(null, ''h:button'', {type: ''button'', onclick: turn}, name))', &
      '}', &
      'well.addEventListener(''pointermove'', e => { if (e.buttons) turn_by(e.movementX / 150, e.movementY / 150) })', &
      'well.addEventListener(''keydown'', e => {', &
      'const by = {ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, -.1], ArrowDown: [0, .1]}[e.key]', &
      'if (by) { e.preventDefault(); turn_by(...by) }', &
      '})', &
      'return {draw, mark}', &
      '}']
   character(169), parameter :: script_lines(684) = [ &
      script_lines_1, &
      script_lines_2, &
      script_lines_3, &
      script_lines_4, &
      script_lines_5, &
      script_lines_6, &
      script_lines_7]
   character(545), parameter :: style_lines_1(33) = [character(545) :: &
      '.scripted .static,html:not(.scripted) .units{display:none}html:not(.scripted) .live{height:0;overflow:hidden;v'// &
      'isibility:hidden}', &
      '.live{--ink:#222;--line:#d8d8d8;--soft:#666;--paper:#fff;--wall:#8c6d46;--steel:#b9c4cc}', &
      '.live svg{width:100%;height:auto;display:block}.live svg text{font-size:11px;fill:currentColor}.live svg .labe'// &
      'l{font-weight:600}', &
      '.live .grid{stroke:var(--line);stroke-width:.7}.live .zero{stroke:var(--soft);stroke-width:1}.live .frame{fill'// &
      ':none;stroke:var(--soft)}', &
      '.live .cross{stroke:#c2185b;transform:translateY(var(--cross))}.live svg .value{font-weight:700;paint-order:st'// &
      'roke;stroke:var(--paper);stroke-width:3px}', &
      '.live .band{fill:#0072B2;opacity:.15;y:var(--band,0);height:var(--bands,0)}.near{stroke:transparent;stroke-wid'// &
      'th:30}.dot,.value{pointer-events:none}.lower svg{touch-action:pan-y}.live .wall{fill:none;stroke:var(--wall);s'// &
      'troke-width:2.5}.live .body{fill:var(--steel);stroke:var(--ink)}', &
      '.live .moment{fill:none;stroke:#0072B2;stroke-width:2}.live .force{stroke:#D55E00;stroke-width:3}.live .shadow'// &
      '{fill:none;stroke:var(--soft);stroke-dasharray:3 3}', &
      '.bare>:not(.bar,.main),.bare .legend,.bare .hint,.bare .readout,.bare .typed,.bare [type=range]{display:none}', &
      '.notice{font-weight:600}.notice:empty{display:none}', &
      '.live .dot{fill:none;stroke:#c2185b;stroke-width:3}', &
      '.bar,.legend{display:flex;flex-wrap:wrap;gap:.4em;margin:.4em 0}.bar button,.legend button,.lower button,.unit'// &
      's{font:inherit;padding:.25em .7em;border:1px solid #888;border-radius:4px;background:none;color:inherit;cursor'// &
      ':pointer}', &
      '.bar .tab[aria-pressed=true]{background:#0072B2;color:#fff}.legend button[aria-pressed=false]{opacity:.4;text-'// &
      'decoration:line-through}', &
      '.legend span{align-self:center;font-size:.85em;margin-right:1em}.live h3{margin:.8em 0 .2em}', &
      '.live .key{width:44px;height:16px;vertical-align:middle;display:inline-block;margin-right:.4em}', &
      '.main{display:grid;grid-template-columns:11em minmax(0,1fr);gap:1em}.side{font-size:.85em}.side select{display'// &
      ':block;width:100%;font:inherit;color:inherit;background:none;border:1px solid #888}', &
      '.legend button{overflow-wrap:anywhere}.readout th{max-width:9em;overflow-wrap:anywhere}.readout th:nth-child(2'// &
      '){overflow-wrap:normal}.readout th+th+th{min-width:8.5em}.panel div{font-size:11px;line-height:1.2}', &
      '.panels{display:flex;flex-wrap:wrap;touch-action:pan-y;user-select:none;cursor:crosshair}', &
      '.right input[type=range]{width:100%}p .units{margin-left:1em}.typed{display:inline-block;margin:.2em 1.5em .2e'// &
      'm 0}.typed input{font:inherit;width:7em}.hint{font-size:.8em;margin:.2em 0}.lower{display:grid;grid-template-c'// &
      'olumns:13em 1fr;gap:1em}.lower figure{max-width:640px}', &
      ':focus-visible{outline:3px solid #E69F00}', &
      '@media screen and (max-width:700px){.lower figure:first-child{max-width:12em;margin:0 auto}.live figure{margin'// &
      ':1em 0}.main,.lower{grid-template-columns:minmax(0,1fr)}}', &
      '@media screen and (prefers-color-scheme:dark){.live{--ink:#dde2e6;--line:#3b444c;--soft:#8a939b;--paper:#14181'// &
      'c;--wall:#b8935f;--steel:#46525b}.live svg{filter:none}', &
      '.live svg [stroke="#c00000"]{stroke:#ff7a6b}.live .cross,.live .dot{stroke:#f06292}}', &
      '@media screen{.first,.printed{display:none}.lead{display:flex;flex-direction:column}.lead .head{order:1}.head '// &
      'p{margin:.3em 0}.head h3{margin:.8em 0 .2em}}', &
      '.more{display:none}', &
      '.lead p{margin:.4em 0}caption{text-align:left;padding:.2em 0}', &
      '.live>div+div .bar{display:none}.hint{display:none}.scripted .hint{display:block}', &
      '@media print{p{margin:.4em 0}h2{margin:.8em 0 .3em}td.word{white-space:nowrap}tbody tr:nth-child(-n+3):not(:la'// &
      'st-child){break-after:avoid}tbody tr:nth-last-child(-n+4):not(:first-child){break-before:avoid}summary{color:i'// &
      'nherit;list-style:none;break-after:avoid}.on-paper{font-size:8.5pt}.on-paper pre{font-size:7pt}.live .panels{f'// &
      'lex-wrap:nowrap}.live svg.panel{width:0!important;flex:1 1 0}.bar,.side,.units,.scripted .hint,.live input,.li'// &
      've label,.live .lower,.live .readout,.live .cross,.live .band,details:not([open]){display:none!important}', &
      '.main{display:block}.right{break-inside:avoid}.live figure svg{max-height:66mm}figure>.live{display:grid;grid-'// &
      'template-columns:1fr 1fr;column-gap:6mm}figure>.live>:only-child{grid-column:1/-1}figure>.live>:last-child:not'// &
      '(:only-child){grid-column:2;grid-row:1/span 9}.live svg.panel{max-height:none}.legend button{border:none;paddi'// &
      'ng:0 .7em 0 0}', &
      '.head{display:grid;grid-template-columns:2fr 3fr;gap:6mm;break-inside:avoid}.head p{margin:.2em 0;font-size:8.'// &
      '5pt}.head h3{margin:0}.first{font-size:8.5pt}.lead h2{margin-top:.6em}.legend{gap:0}', &
      '.lead{display:flex;flex-direction:column}.lead .wide,.answers,.answers tbody{display:contents}', &
      '.answers tr{display:grid;grid-template-columns:14em 6em 1fr;font-size:8pt;padding:.1em .4em;border-bottom:1px '// &
      'solid #ddd;break-inside:avoid}.answers td{padding:0;border:none}', &
      '.lead tbody tr{break-before:auto;break-after:auto}.wide~.note,.answers .more{order:8}.head{order:9}.answers .m'// &
      'ore{font-weight:600}.more td{grid-column:1/-1}', &
      '.head td,.head th{padding:0 .4em;line-height:1.25}h1{font-size:14pt;margin:0}h1+p{margin:.2em 0}.lead .note{fo'// &
      'nt-size:8pt;margin:.4em 0;padding:.1em .8em}.lead h2{font-size:11pt}}']
   character(545), parameter :: style_lines(33) = [ &
      style_lines_1]
end module dg_page_script
