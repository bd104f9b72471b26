!> The script and the style that a page carries: page.js, well.js, page.css. The hash of the script lets it run.
!> Written by .ci/embed_page.py --write; change those files, not this.
module dg_page_script
   implicit none
   private
   public :: script_hash, script_lines, style_lines

   character(*), parameter :: script_hash = 'nYzu6YjoN6u3ASP6gxXZFZzgwLuzSk6qa/oAZmQwEMU='
   character(185), parameter :: script_lines_1(100) = [character(185) :: &
      '''use strict''', &
      'const D = JSON.parse(document.getElementById(''data'').textContent)', &
      'const shapes = [''m0-5v10m-5-5h10'', ''m-4-4l8 8m0-8l-8 8'', ''m0-5v10m-4.3-7.5l8.6 5m0-5l-8.6 5'', ''m-4-4h8v'// &
      '8h-8z'', ''m-4 0a4 4 0 1 0 8 0a4 4 0 1 0-8 0z'',', &
      '''m0-5l5 8.5h-10z'', ''m0 5l5-8.5h-10z'', ''m0-5.5l4.5 5.5l-4.5 5.5l-4.5-5.5z'', ''m0-5l4.8 3.5l-1.8 5.5h-6l-1'// &
      '.8-5.5z'']   // gnuplot''s marks', &
      'const blocks = []                                            // all charts of the page that answer', &
      'const shown_length = 40 / D.quantities.length.SI[1]          // of the assembly in its hole', &
      'let units = D.systems.includes(D.units) ? D.units : D.systems[0], clips = 0, noting = 0, active = null', &
      'let paper = null                                             // while the page is printed: width and height of'// &
      ' charts', &
      'function curve_of(text) {                                    // "step value step value ..." in thousandths of '// &
      'D.units'' length', &
      'const t = text === '''' ? [] : text.split('' ''), n = t.length / 2, d = new Float64Array(n), v = new Float64Ar'// &
      'ray(n)', &
      'for (let i = 0, sum = 0; i < n; i++) { d[i] = (sum += +t[2 * i]) / 1000; v[i] = t[2 * i + 1] === '''' ? NaN : '// &
      '+t[2 * i + 1] }', &
      'return {d, v}', &
      '}', &
      'for (const p of D.profiles ?? []) for (const name in p.curves) {', &
      'const curve = p.curves[name]                              // a number: the same as an earlier one', &
      'p.curves[name] = typeof curve === ''number'' ? D.profiles[curve].curves[name] : curve_of(curve)', &
      '}', &
      'const limit_look = {mark: 0, look: {stroke: ''currentColor'', ''stroke-dasharray'': ''2 3'', ''stroke-width'':'// &
      ' 1}}', &
      'for (const panel of (D.charts ?? []).flatMap(c => c.panels)) {', &
      'panel.quantity = D.columns[panel.curves[0].column].quantity', &
      'panel.lines = D.profiles.flatMap((p, k) => panel.curves.filter(c => p.curves[c.column]).map(c => ({', &
      '...p.key, ...c, name: p.key.text, keys: [k], case: p.case, curve: p.curves[c.column], turns: c.column === ''cl'// &
      'ock'', ...(c.limit && limit_look)', &
      '})))', &
      '}', &
      'const meanings = Object.fromEntries(Object.values(D.columns ?? {}).map(c => [c.label, c.meaning]))', &
      'for (const line of D.figures.flatMap(f => f.blocks).flatMap(b => b.panels).flatMap(panel => panel.lines)) {', &
      'line.curve = curve_of(line.points)', &
      'if (line.low) { line.low = curve_of(line.low).v; line.high = curve_of(line.high).v }', &
      '}', &
      'const factor = q => D.quantities[q]?.[units]?.[1] ?? 1, unit = q => D.quantities[q]?.[units]?.[0] ?? q', &
      'const row_at = ({d}, depth) => Math.max(0, Math.min(d.findLastIndex(place => place <= depth), d.length - 2))  '// &
      ' // at or above it', &
      'const reaches = ({d}, depth) => depth >= d[0] && depth <= d[d.length - 1]', &
      'function value_in(c, depth, words, turns) {', &
      'if (!c || !reaches(c, depth)) return NaN', &
      'const i = row_at(c, depth), part = (depth - c.d[i]) / (c.d[i + 1] - c.d[i]) || 0', &
      'if (words) return c.v[part < .5 ? i : i + 1]', &
      'if (part === 0 || part === 1) return c.v[i + part]        // a value may lack beside it', &
      'let turn = c.v[i + 1] - c.v[i]', &
      'if (turns) turn = ((turn + 540) % 360) - 180              // the short way round', &
      'const v = c.v[i] + part * turn', &
      'return turns ? (v + 360) % 360 : v', &
      '}', &
      'const value_at = (p, name, depth) => value_in(p.curves[name], depth, D.columns[name].words, name === ''clock'''// &
      ')', &
      'function text_of(value, q) {', &
      'if (!isFinite(value)) return ''\u2013''', &
      'const v = value * factor(q), a = Math.abs(v)', &
      'return v.toFixed(a >= 1000 ? 0 : a >= 100 ? 1 : a >= 10 ? 2 : 3)', &
      '}', &
      'const depth_text = depth => text_of(depth, ''length'') + '' '' + unit(''length'')', &
      'const round_text = depth => depth_text(depth).replace(/\.0+ /, '' '')', &
      'function make(parent, tag, attributes, text) {', &
      'const e = tag.startsWith(''h:'') ? document.createElement(tag.slice(2)) : document.createElementNS(''http://ww'// &
      'w.w3.org/2000/svg'', tag)', &
      'for (const k in attributes) if (k.startsWith(''on'')) e.addEventListener(k.slice(2), attributes[k]); else e.se'// &
      'tAttribute(k, attributes[k])', &
      'if (text !== undefined) e.textContent = text', &
      'parent?.append(e)', &
      'return e', &
      '}', &
      'function ticks(low, high, most) {', &
      'const raw = (high - low) / most, power = 10 ** Math.floor(Math.log10(raw)), step = power * [1, 2, 5, 10].find('// &
      'f => f * power >= raw)', &
      'const from = Math.ceil(low / step - 1e-9), to = Math.floor(high / step + 1e-9)', &
      'return Array.from({length: Math.max(0, to - from + 1)}, (_, i) => +((from + i) * step).toPrecision(12))', &
      '}', &
      'const put_marks = (parent, d, mark, ink) => make(parent, ''path'', {d, ''stroke-width'': 1.6, fill: mark > 4 &'// &
      '& mark % 2 ? ink : ''none'', stroke: ink})', &
      'const shape_of = mark => shapes[mark < 4 ? mark - 1 : (mark >> 1) + 1]', &
      'function draw_key(parent, {mark, marks, look}) {             // a piece of a line, or a mark', &
      'const svg = make(parent, ''svg'', {viewBox: ''0 -4 28 16'', class: ''key''})', &
      'if (!marks) make(svg, ''line'', {x1: 0, x2: 28, y1: 4, y2: 4, ''stroke-width'': 3, ...look})', &
      'if (mark) put_marks(svg, ''M14 4'' + shape_of(mark), mark, look.stroke)', &
      '}', &
      'function block(root, S) {', &
      'const state = {cases: [D.start], chart: 0, depth: undefined, hidden: new Set(), tint: ''side_force_on_joint'','// &
      ' yaw: -0.6, pitch: 0.35, near: 1}', &
      'const end_of = () => S.rows ? S.rows.length + .6 : S.end ?? Math.max(...(state.cases.length ? state.cases : [D'// &
      '.start]).map(i => D.cases[i].depth))', &
      'const first = state.top = S.rows ? .4 : 0, view = {}, up = 30, down = 26', &
      'let H                                                        // height of a panel', &
      'const y_of = depth => up + (depth - state.top) / (state.bottom - state.top) * (H - up - down)', &
      'const depth_of = y => state.top + (y - up) / (H - up - down) * (state.bottom - state.top)', &
      'const place_text = () => S.rows ? S.rows[state.depth - 1] : depth_text(state.depth)', &
      'const panels_of = () => S.panels ?? S.charts[state.chart].panels', &
      'const lines_of = panel => panel.lines.filter(l => !S.charts || state.cases.includes(l.case))', &
      'const visible = line => !line.keys.some(k => state.hidden.has(k))', &
      'const shown = () => D.profiles.filter((p, k) => state.cases.includes(p.case) && !state.hidden.has(k))', &
      'function row_beside({curve: {d, v}}) {                       // of marks the nearest one, if it is near the de'// &
      'pth that is pointed at', &
      'const far = i => Math.abs(d[i] - state.depth), near = S.rows ? .5 : 6 / (H - up - down) * (state.bottom - stat'// &
      'e.top)', &
      'return [...d.keys()].filter(i => isFinite(v[i]) && far(i) <= near).sort((a, b) => far(a) - far(b))[0] ?? -1', &
      '}', &
      'function value_of(line) {                                    // at the depth that is pointed at', &
      'if (line.marks) return line.curve.v[row_beside(line)] ?? NaN', &
      'return (line.sign ?? 1) * value_in(line.curve, state.depth, false, line.turns)', &
      '}', &
      'function shown_of(line, q) {', &
      'const text = text_of(value_of(line), q), i = line.low ? row_beside(line) : -1', &
      'return i < 0 ? text : `${text} (${text_of(line.low[i], q)} to ${text_of(line.high[i], q)})`', &
      '}', &
      'function path_of(curve, [from, to], x_of, turns) {           // with a gap where a value lacks, or an angle pa'// &
      'sses a full turn', &
      'let path = '''', gap = true', &
      'for (let i = from; i < to; i++) {', &
      'const v = curve.v[i], at = x_of(v).toFixed(1) + '' '' + y_of(curve.d[i]).toFixed(1)', &
      'gap ||= turns && Math.abs(v - curve.v[i - 1]) > 180', &
      'if (isFinite(v)) path += gap ? `M${at}h0` : ''L'' + at', &
      'gap = !isFinite(v)']
   character(185), parameter :: script_lines_2(100) = [character(185) :: &
      '}', &
      'return path', &
      '}', &
      'function range_of(panel, lists, rows) {                      // of what is seen; along the string 0 is among i'// &
      't', &
      'if (panel.high !== undefined) return [panel.low, panel.high]', &
      'const all = S.charts ? [0] : []', &
      'lists.forEach((l, k) => {', &
      'if (!l.limit) for (let i = rows[k][0]; i < rows[k][1]; i++) all.push((l.sign ?? 1) * l.curve.v[i], l.low?.[i],'// &
      ' l.high?.[i])', &
      '})', &
      'const known = all.filter(v => isFinite(v)), least = known.reduce((a, b) => Math.min(a, b), panel.low ?? known['// &
      '0] ?? 0)', &
      'const most = known.reduce((a, b) => Math.max(a, b), least), air = (most - least) * .05 || 1', &
      'return [least === (panel.low ?? 0) ? least : least - air, Math.min(most + air, panel.most ?? Infinity)]', &
      '}', &
      'const seen_in = c => [row_at(c, state.top), Math.min(c.d.length, row_at(c, state.bottom) + 2)]       // of its'// &
      ' points: from, and before', &
      'function draw_axis(svg, left, right, first_of_row) {         // depths, or names of rows', &
      'const level = (at, name) => {', &
      'const y = y_of(at), most = Math.floor((left - 6) / 6.4), short = name.length > most ? name.slice(0, most - 1) '// &
      '+ ''\u2026'' : name', &
      'make(svg, ''line'', {x1: left, x2: right, y1: y, y2: y, class: ''grid''})', &
      'if (first_of_row) make(make(svg, ''text'', {x: left - 4, y: y + 4, ''text-anchor'': ''end''}, short), ''title'''// &
      ', {}, name)', &
      '}', &
      'const length = factor(''length'')', &
      'if (S.rows) S.rows.forEach((name, i) => level(i + 1, name))', &
      'else for (const t of ticks(state.top * length, state.bottom * length, H / 47)) level(t / length, String(t))', &
      '}', &
      'function draw_line(clip, line, rows, x_of) {', &
      'const {look, mark, curve} = line, x = v => x_of((line.sign ?? 1) * v), ink = look.stroke', &
      'const mark_at = ({d, v}) => {', &
      'const there = [...d.keys()].filter(i => isFinite(v[i]))', &
      'put_marks(clip, there.map(i => `M${x(v[i]).toFixed(1)} ${y_of(d[i]).toFixed(1)}${shape_of(mark)}`).join(''''),'// &
      ' mark, ink)', &
      '}', &
      'if (line.low) {                                           // bars, with a mark in thick ones', &
      'const d = [...curve.d].map((d, i) => `M${x(line.low[i])} ${y_of(d)}H${x(line.high[i])}`).join('''')', &
      'make(clip, ''path'', {d, stroke: ink, ''stroke-width'': line.thick ? 14 : 2})', &
      'if (line.thick) mark_at(curve)', &
      '} else if (line.marks) {', &
      'mark_at(curve)', &
      '} else {', &
      'const d = path_of(curve, rows, x, line.turns)', &
      'make(clip, ''path'', {d, fill: ''none'', ''stroke-width'': 1.7, ''stroke-linecap'': ''round'', ...look})', &
      'if (!mark) return                                      // else marks here and there, for print without colours', &
      'const at = Array.from({length: 8}, (_, i) => state.top + (i + .5) / 8 * (state.bottom - state.top))', &
      'mark_at({d: at, v: at.map(d => value_in(curve, d, false, line.turns))})', &
      '}', &
      '}', &
      'function draw_panel(panel, index, width) {', &
      'const svg = make(null, ''svg'', {viewBox: `0 0 ${width} ${H}`, role: ''img'', ''aria-label'': panel.label, cla'// &
      'ss: ''panel''})', &
      'const longest = S.rows ? Math.max(...S.rows.map(n => n.length)) : 0', &
      'const left = index ? 12 : S.rows ? Math.min(.4 * width, 12 + 6.4 * longest) : 46, right = width - 16', &
      'const lists = lines_of(panel).filter(visible), rows = lists.map(l => l.marks ? [0, l.curve.d.length] : seen_in'// &
      '(l.curve)), q = panel.quantity, f = factor(q)', &
      'const [low, high] = range_of(panel, lists, rows).map(v => v * f)', &
      'const x_of = v => left + (v * f - low) / (high - low) * (right - left)', &
      'make(make(svg, ''clipPath'', {id: ''clip'' + ++clips}), ''rect'', {x: left, y: up, width: right - left, height'// &
      ': H - up - down})', &
      'for (const t of panel.ticks ?? ticks(low, high, Math.max(3, (right - left) / 50))) {', &
      'const x = x_of(t / f)', &
      'make(svg, ''line'', {x1: x, x2: x, y1: up, y2: H - down, class: t ? ''grid'' : ''zero''})', &
      'make(svg, ''text'', {x, y: H - down + 15, ''text-anchor'': ''middle''}, t)', &
      '}', &
      'draw_axis(svg, left, right, !index)', &
      'make(svg, ''rect'', {x: left, y: up, width: right - left, height: H - up - down, class: ''frame''})', &
      'const words = make(make(svg, ''foreignObject'', {x: left, y: 0, width: right - left, height: up}), ''h:div'', '// &
      '{})', &
      'make(words, ''h:b'', {}, panel.label + '' '')', &
      'if (unit(q)) words.append(`[${unit(q)}]`)', &
      'const clip = make(svg, ''g'', {''clip-path'': `url(#clip${clips})`})', &
      'lists.forEach((line, k) => draw_line(clip, line, rows[k], x_of))', &
      'make(svg, ''line'', {x1: left, x2: right, y1: 0, y2: 0, class: ''cross''})', &
      'make(svg, ''rect'', {x: left, width: right - left, class: ''band''})', &
      'return svg', &
      '}', &
      'function draw_panels() {', &
      'const panels = panels_of(), bare = !panels.flatMap(lines_of).length', &
      'root.classList.toggle(''bare'', bare)                       // an empty chart is not drawn', &
      'if (bare) {', &
      'view.panels.textContent = ''No curves: choose a load case that has a solution. Answers and warnings above say '// &
      'why others have none.''', &
      'return', &
      '}', &
      'const wide = paper?.wide ?? (view.panels.clientWidth || 1000)', &
      'const abreast = Math.min(panels.length, wide >= 600 ? Infinity : S.rows ? 1 : 2)', &
      'view.panels.replaceChildren(...panels.map((p, i) => draw_panel(p, i % abreast, Math.max(150, wide / abreast)))'// &
      ')', &
      'for (const s of view.panels.children) s.style.width = 100 / abreast + ''%''', &
      'set_depth(state.depth)', &
      '}', &
      'function set_depth(depth) {                                  // the slider keeps it within its range, and rows'// &
      ' whole', &
      'view.slider.value = depth', &
      'state.depth = +view.slider.value', &
      'view.panels.style.setProperty(''--cross'', y_of(state.depth) + ''px'')', &
      'view.well?.mark()', &
      'draw_readout()', &
      'note_address()', &
      '}', &
      'function cells_of_profiles() {                               // a row a quantity', &
      'const list = shown(), wanted = panels_of().flatMap(p => p.curves.map(c => c.column)), both = list.length === 2', &
      'const names = view.all.checked ? Object.keys(D.columns) : [...new Set(wanted)]', &
      'const parts = list.map(p => D.cases[p.case].parts.find(part => D.cases[p.case].depth - state.depth <= part.to)'// &
      '?.name ?? ''\u2013'')', &
      'return [[''quantity'', ''unit'', ...list.map(p => p.key.text), ...(both ? [''difference''] : [])], [''componen'// &
      't'', '''', ...parts, ...(both ? [''''] : [])], ...names.map(n => {', &
      'const c = D.columns[n], v = list.map(p => value_at(p, n, state.depth)), text = x => c.words ? c.words[x] ?? '''// &
      '\u2013'' : text_of(x, c.quantity)', &
      'return [c.label, unit(c.quantity), ...v.map(text), ...(both ? [c.words ? '''' : text(v[1] - v[0])] : [])]', &
      '})]', &
      '}', &
      'function cells_of_lines() {                                  // a row a line: all that reach the depth, of mar'// &
      'ks those that are near', &
      'const panels = panels_of(), lines = panels.map(p => lines_of(p).filter(visible))']
   character(185), parameter :: script_lines_3(100) = [character(185) :: &
      'const near = lines.flat().filter(l => l.marks ? isFinite(value_of(l)) : reaches(l.curve, state.depth))', &
      'const heads = panels.map(p => p.label + (unit(p.quantity) ? ` [${unit(p.quantity)}]` : ''''))', &
      'const cell = (name, k) => lines[k].filter(l => l.name === name).map(l => shown_of(l, panels[k].quantity)).find'// &
      '(text => text !== ''\u2013'') ?? ''\u2013''', &
      'return [[''curve'', ...heads], ...[...new Set(near.map(l => l.name))].map(name => [name, ...panels.map((_, k) '// &
      '=> cell(name, k))])]', &
      '}', &
      'function draw_readout() {                                    // a table; a screen reader has its words from th'// &
      'e slider', &
      'const table = make(null, ''h:table'', {}), rows = S.charts ? cells_of_profiles() : cells_of_lines()', &
      'make(table, ''h:caption'', {}, ''At '' + place_text() + (S.rows ? '''' : '' '' + S.over))', &
      'rows.forEach((row, k) => {', &
      'const line = make(table, ''h:tr'', {})', &
      'row.forEach((text, i) => make(line, k ? ''h:td'' : ''h:th'', {class: i ? '''' : ''text'', title: meanings[text'// &
      '] ?? ''''}, text))', &
      '})', &
      'view.readout.replaceChildren(table)', &
      'view.slider.setAttribute(''aria-valuetext'', [place_text(), ...rows.map(row => row.join('' ''))].join('', ''))', &
      '}', &
      'function draw() {', &
      'const end = end_of()', &
      'H = S.rows ? 64 + 24 * S.rows.length : paper?.high ?? 420', &
      'if (!(state.bottom > state.top) || state.bottom > end) { state.top = first; state.bottom = end }', &
      'Object.assign(view.slider, S.rows ? {min: 1, max: S.rows.length} : {min: state.top, max: state.bottom})', &
      'view.units.textContent = ''units: '' + units', &
      'draw_legend()', &
      'draw_panels()', &
      'view.well?.draw()', &
      '}', &
      'function draw_legend() {                                     // an entry in white is words alone; one without '// &
      'a line is left out', &
      'const used = new Set(panels_of().flatMap(lines_of).flatMap(l => l.keys))', &
      'view.legend.replaceChildren()', &
      'S.keys.forEach((key, id) => {', &
      'if (key.words) make(view.legend, ''h:span'', {}, key.text)', &
      'if (key.words || !used.has(id)) return', &
      'const turn = () => { state.hidden.has(id) ? state.hidden.delete(id) : state.hidden.add(id); draw() }', &
      'const b = make(view.legend, ''h:button'', {type: ''button'', ''aria-pressed'': !state.hidden.has(id), onclick:'// &
      ' turn})', &
      'draw_key(b, key)', &
      'b.append(key.text)', &
      '})', &
      '}', &
      'function build() {', &
      'const bar = make(root, ''h:div'', {class: ''bar''}), zoom = (top, bottom) => { state.top = top; state.bottom ='// &
      ' bottom; draw() }', &
      'const whole = () => zoom(first, end_of())', &
      'const button = (text, onclick, more) => make(bar, ''h:button'', {type: ''button'', onclick, ...more}, text)', &
      'const choose = i => { state.chart = i; bar.querySelectorAll(''.tab'').forEach((o, k) => o.setAttribute(''aria-'// &
      'pressed'', k === i)); draw() }', &
      'S.charts?.forEach((c, i) => button(c.title, () => choose(i), {''aria-pressed'': i === state.chart, class: ''ta'// &
      'b''}))', &
      'view.units = button('''', () => {', &
      'units = D.systems[(D.systems.indexOf(units) + 1) % D.systems.length]', &
      'draw_all()', &
      '})', &
      'if (!S.rows) button(''whole depth'', whole)', &
      'if (S.charts) button(''lowest '' + round_text(shown_length), () => zoom(Math.max(0, end_of() - shown_length), '// &
      'end_of()))', &
      'const main = make(root, ''h:div'', {class: S.charts ? ''main'' : ''alone''})', &
      'if (S.charts) {', &
      'const label = make(main, ''h:label'', {class: ''side''}, ''Load cases, several with Ctrl'')', &
      'const list = make(label, ''h:select'', {multiple: '''', size: Math.min(1 + D.cases.length, 16)})', &
      'D.cases.forEach((c, i) => make(list, ''h:option'', {value: i}, c.name).selected = state.cases.includes(i))', &
      'list.onchange = () => { state.cases = [...list.selectedOptions].map(o => +o.value); draw() }', &
      '}', &
      'const right = make(main, ''h:div'', {class: ''right''})', &
      'view.legend = make(right, ''h:div'', {class: ''legend''})', &
      'view.panels = make(right, ''h:div'', {class: ''panels''})', &
      'view.slider = make(right, ''h:input'', {type: ''range'', step: S.rows ? 1 : ''any'', ''aria-label'': S.over ??'// &
      ' ''row'', oninput: e => set_depth(+e.target.value),', &
      'onkeydown: e => { const way = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1}[e.key]; if (way) { e.p'// &
      'reventDefault(); set_depth(state.depth + way * (e.shiftKey ? 10 : 1)) } }})', &
      'view.readout = make(right, ''h:div'', {class: ''wide readout''})', &
      'if (S.charts) {', &
      'const label = make(right, ''h:label'', {})', &
      'view.all = make(label, ''h:input'', {type: ''checkbox'', onchange: draw_readout})', &
      'label.append('' all columns'')', &
      'view.well = well_figures({root, state, shown, place_text, set_depth})', &
      '}', &
      'listen(zoom)', &
      'view.panels.addEventListener(''dblclick'', whole)', &
      'for (const kind of [''pointerenter'', ''focusin'']) root.addEventListener(kind, () => active = S)', &
      'state.bottom ??= end_of()', &
      'state.depth ??= S.rows ? 1 : S.end ?? state.bottom / 2', &
      'draw()', &
      '}', &
      'function listen(zoom) {                                      // a mouse is dragged over what to zoom to, two f'// &
      'ingers spread it', &
      'let from = NaN, pinch = null, wanted = null', &
      'const y_in = ({target, clientY}) => {', &
      'const place = target.closest(''svg.panel'')?.getBoundingClientRect()', &
      'return place ? (clientY - place.top) / place.height * H : NaN', &
      '}', &
      'const want = (top, bottom) => {                           // shown as a band', &
      'wanted = [Math.max(first, top), Math.min(end_of(), bottom)]', &
      'view.panels.style.setProperty(''--band'', y_of(wanted[0]) + ''px'')', &
      'view.panels.style.setProperty(''--bands'', Math.max(0, y_of(wanted[1]) - y_of(wanted[0])) + ''px'')', &
      '}', &
      'const point = e => {', &
      'const y = y_in(e)', &
      'if (isNaN(y)) return', &
      'if (e.type === ''pointerdown'' && e.pointerType === ''mouse'' && !S.rows) from = y', &
      'set_depth(depth_of(y))', &
      'if (Math.abs(y - from) > 6) want(depth_of(Math.min(from, y)), depth_of(Math.max(from, y)))', &
      '}', &
      'const spread = e => {', &
      'if (e.touches.length !== 2 || S.rows) return', &
      'e.preventDefault()', &
      'const [a, b] = [...e.touches].map(y_in).sort((a, b) => a - b)', &
      'pinch ??= [depth_of(a), depth_of(b)]', &
      'const step = (pinch[1] - pinch[0]) / Math.max(b - a, 20), top = Math.max(0, pinch[0] - step * (a - up))', &
      'want(top, top + step * (H - up - down))']
   character(185), parameter :: script_lines_4(100) = [character(185) :: &
      '}', &
      'const finish = () => {', &
      'if (wanted?.[1] > wanted?.[0]) zoom(...wanted)', &
      'view.panels.style.removeProperty(''--bands'')', &
      'from = NaN', &
      'pinch = wanted = null', &
      '}', &
      'for (const kind of [''pointerdown'', ''pointermove'']) view.panels.addEventListener(kind, point)', &
      'for (const kind of [''touchstart'', ''touchmove'']) view.panels.addEventListener(kind, spread, {passive: false'// &
      '})', &
      'for (const kind of [''pointerup'', ''touchend'']) addEventListener(kind, finish)', &
      '}', &
      'function from_address(q) {                                    // #case=NAME&case=NAME&chart=TITLE&depth=M&top='// &
      'M&bottom=M&units=field', &
      'const found = (list, name) => list.findIndex(c => (c.name ?? c.title) === name)', &
      'if (S.charts && q.has(''case'')) state.cases = q.getAll(''case'').map(n => found(D.cases, n)).filter(i => i >='// &
      ' 0)', &
      'if (S.charts && q.has(''chart'')) state.chart = Math.max(0, found(D.charts, q.get(''chart'')))', &
      'for (const k of [''depth'', ''top'', ''bottom'']) if (isFinite(parseFloat(q.get(k)))) state[k] = parseFloat(q.'// &
      'get(k))', &
      '}', &
      'function note_address() {                                     // after a pause: the view is a link', &
      'if (active !== S) return', &
      'clearTimeout(noting)', &
      'noting = setTimeout(() => {', &
      'const cases = S.charts ? state.cases.map(i => [''case'', D.cases[i].name]) : [], q = new URLSearchParams(cases'// &
      ')', &
      'q.set(''chart'', S.title ?? S.charts[state.chart].title)', &
      'for (const k of state.top > first || state.bottom < end_of() ? [''depth'', ''top'', ''bottom''] : [''depth''])'// &
      ' q.set(k, +state[k].toFixed(2))', &
      'if (units !== D.units) q.set(''units'', units)', &
      'history.replaceState(null, '''', ''#'' + q)', &
      '}, 300)', &
      '}', &
      'if (active === S) from_address(new URLSearchParams(location.hash.slice(1)))', &
      'build()', &
      'return {root, S, state, draw}', &
      '}', &
      'function draw_all() { for (const b of blocks) b.draw() }', &
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
      'addEventListener(''resize'', draw_all)', &
      'const draw_for = size => { paper = size; draw_all() }', &
      'addEventListener(''afterprint'', () => draw_for(null))', &
      'addEventListener(''beforeprint'', () => {                       // the first sheet has the load case nearest t'// &
      'o a limit, the others what is shown', &
      'if (D.profiles) {', &
      'paper = {wide: 660, high: 300}', &
      'const {root} = block(make(null, ''h:div'', {}), {keys: D.profiles.map(p => p.key), charts: [{panels: D.charts['// &
      '0].panels.slice(0, 4)}]})', &
      'document.querySelector(''.first'').replaceChildren(...root.querySelectorAll(''.legend, .panels''))', &
      '}', &
      'draw_for({wide: 1100, high: 260})', &
      '})', &
      'const places = [...document.querySelectorAll(''.live:not(.first)'')]', &
      'try {', &
      'const of_figure = (f, place) => f.blocks.map((b, i) => ({...b, keys: f.keys, title: f.title + (i ? ` (${i + 1}'// &
      ')` : ''''), place}))', &
      'const along = D.profiles ? [{charts: D.charts, keys: D.profiles.map(p => p.key), over: ''measured depth'', pla'// &
      'ce: places[0]}] : []', &
      'const all = [...along, ...D.figures.flatMap((f, i) => of_figure(f, places[along.length + i]))]', &
      'follow_address(all)', &
      'for (const S of all) blocks.push(block(make(S.place, ''h:div'', {}), S))', &
      'document.documentElement.classList.add(''scripted'')', &
      'if (location.hash) blocks.find(b => b.S === active).root.scrollIntoView()', &
      '} catch (fault) {                                             // fixed pictures, as without a script', &
      'for (const place of places) place.replaceChildren()', &
      'throw fault', &
      '}', &
      'function well_figures(b) {', &
      'const {root, state, shown} = b, angle = (p, d) => value_at(p, ''clock'', d) * Math.PI / 180', &
      'const lower = make(root, ''h:div'', {class: ''lower''})', &
      'const picture = (parent, label, more) => make(make(parent, ''h:figure'', {}), ''svg'', {role: ''img'', ''aria-'// &
      'label'': label, ...more})', &
      'const section = picture(lower, ''string in the hole at this depth'', {viewBox: ''0 -6 200 200''})', &
      'const well = picture(lower, ''the well in three dimensions'', {viewBox: ''0 0 460 440'', tabindex: 0})', &
      'const assembly = picture(root, ''lowest part of the string in the hole''), scale = make(assembly.parentNode, '''// &
      'h:figcaption'', {})', &
      'const pick = make(null, ''h:select'', {''aria-label'': ''colour of the well'', onchange: () => { state.tint = '// &
      'pick.value; draw_well() }})', &
      'const colour = part => `hsl(${230 - 225 * Math.min(part, 1)} 75% 48%)`     // blue, green, yellow, red', &
      'let mark_well = () => {}', &
      'function writer(svg, width) {                                // writes texts, each unless it would hide an ear'// &
      'lier one', &
      'const taken = []', &
      'return (x, y, text) => {', &
      'const half = 3.6 * text.length, at = Math.min(Math.max(x, half), width - half)', &
      'if (taken.some(t => Math.abs(t.y - y) < 13 && Math.abs(t.at - at) < t.half + half + 4)) return', &
      'taken.push({at, half, y})', &
      'make(svg, ''text'', {x: at, y, ''text-anchor'': ''middle''}, text)', &
      '}', &
      '}', &
      'function draw_section() {                                    // the hole at the depth, seen down the hole, hig'// &
      'h side up', &
      'section.replaceChildren()', &
      'shown().forEach((p, i) => {', &
      'const scale = 88 / value_at(p, ''hole'', state.depth)', &
      'if (!i) make(section, ''circle'', {cx: 100, cy: 100, r: 88, class: ''wall''})', &
      'if (!i) make(section, ''text'', {x: 100, y: 9, ''text-anchor'': ''middle''}, ''high side'')', &
      'const off = value_at(p, ''displacement'', state.depth) * 2 * scale, a = angle(p, state.depth), r = value_at(p,'// &
      ' ''od'', state.depth) * scale', &
      'make(section, ''circle'', {cx: 100 + off * Math.sin(a), cy: 100 - off * Math.cos(a), r, fill: ''none'', ''stro'// &
      'ke-width'': 2, ...p.key.look})', &
      '})', &
      '}', &
      'function draw_well() {', &
      'const [p] = shown(), place = d => [''east'', ''north'', ''tvd''].map(name => value_at(p, name, d))']
   character(185), parameter :: script_lines_5(86) = [character(185) :: &
      'well.replaceChildren()', &
      'mark_well = () => {}', &
      'if (!p) return', &
      'const end = D.cases[p.case].depth, n = 400, {label, quantity} = D.columns[state.tint]', &
      'const points = Array.from({length: n + 1}, (_, i) => i / n * end).map(d => ({d, at: place(d), value: value_at('// &
      'p, state.tint, d)}))', &
      'const ends = [0, 1, 2].map(k => [Math.min(0, ...points.map(a => a.at[k])), Math.max(1, ...points.map(a => a.at'// &
      '[k]))])', &
      'const size = Math.max(...ends.map(e => e[1] - e[0])), middle = ends.map(e => (e[0] + e[1]) / 2)', &
      'const [[e0, e1], [n0, n1], [, z1]] = ends.map((e, k) => (e[1] - e[0] < .2 * size ? [middle[k] - .1 * size, mid'// &
      'dle[k] + .1 * size] : e))', &
      'const cy = Math.cos(state.yaw), sy = Math.sin(state.yaw), cp = Math.cos(state.pitch), sp = Math.sin(state.pitc'// &
      'h), s = 290 * state.near / size', &
      'const project = a => {', &
      'const e = a[0] - middle[0], m = a[1] - middle[1], z = a[2] - middle[2]', &
      'return [230 + s * (e * cy - m * sy), 180 + s * (z * cp - (e * sy + m * cy) * sp)]', &
      '}', &
      'const line = (a, b, look) => make(well, ''path'', {d: ''M'' + [a, b].map(project).join(''L''), ...look})', &
      'const write = writer(well, 460), sorted = points.map(a => a.value).filter(isFinite).sort((a, b) => a - b)', &
      'const low = sorted[0], high = sorted[Math.floor(.99 * (sorted.length - 1))], beyond = sorted[sorted.length - 1'// &
      '] > high ? ''\u2265 '' : ''''', &
      'for (let i = 0; i < 40; i++) make(well, ''rect'', {x: 20 + 5 * i, y: 412, width: 5.5, height: 9, fill: colour('// &
      'i / 39)})', &
      'write(120, 434, text_of(low, quantity) + '' to '' + beyond + text_of(high, quantity))', &
      'write(0, 406, `${label} [${unit(quantity)}], ${p.key.text}`.slice(0, 60))', &
      'const grid = (name, axis, from, to, corner, other) => {   // lines across an axis, none where it is seen from '// &
      'its end', &
      'const at = (t, point) => point.map((v, k) => (k === axis ? t : v)), length = factor(''length'')', &
      'const [[x1, y1], [x2, y2]] = [from, to].map(t => project(at(t, corner))), few = Math.min(5, Math.round(Math.hy'// &
      'pot(x2 - x1, y2 - y1) / 40))', &
      'if (few) for (const t of ticks(from * length, to * length, few)) {', &
      'const [x, y] = project(at(t / length, corner))', &
      'line(at(t / length, corner), at(t / length, other), {class: ''grid''})', &
      'if (Math.abs(x2 - x1) > Math.abs(y2 - y1)) write(x, y + 16, name + t); else write(x + (x < 230 ? -30 : 30), y '// &
      '+ 4, name + t)', &
      '}', &
      '}', &
      'grid('''', 2, 0, z1, [e1, n1, 0], [e0, n1, 0])', &
      'grid(''E '', 0, e0, e1, [0, n0, z1], [0, n1, z1])', &
      'grid(''N '', 1, n0, n1, [e0, 0, z1], [e1, 0, z1])', &
      'make(well, ''path'', {class: ''shadow'', d: ''M'' + points.map(a => project([a.at[0], a.at[1], z1])).join(''L'''// &
      ')})', &
      'points.slice(0, n).forEach((a, i) => {', &
      'const stroke = isFinite(a.value) ? colour((a.value - low) / (high - low || 1)) : ''#888''', &
      'line(a.at, points[i + 1].at, {stroke, ''stroke-width'': 5, ''stroke-linecap'': ''round''})', &
      '})', &
      'points.slice(0, n).forEach((a, i) => line(a.at, points[i + 1].at, {class: ''near'', onpointerenter: () => b.se'// &
      't_depth(a.d)}))', &
      'const dot = make(well, ''g'', {})', &
      'mark_well = () => {', &
      'const [x, y] = project(place(Math.min(state.depth, end)))', &
      'dot.replaceChildren()', &
      'make(dot, ''circle'', {cx: x, cy: y, r: 6, class: ''dot''})', &
      'make(dot, ''text'', {x: x + 9, y: y - 6, class: ''value''}, b.place_text() + '': '' + text_of(value_at(p, stat'// &
      'e.tint, state.depth), quantity))', &
      '}', &
      'mark_well()', &
      '}', &
      'function draw_assembly() {                                   // the lowest 40 m from the side, high side up', &
      'const [p] = shown(), W = paper?.wide ?? Math.max(320, root.clientWidth || 1000), T = 290', &
      'assembly.replaceChildren()', &
      'assembly.setAttribute(''viewBox'', `0 0 ${W} ${T}`)', &
      'if (!p) return', &
      'const bit = D.cases[p.case].depth, top = bit - shown_length, x_of = d => 10 + (d - top) / shown_length * (W - '// &
      '30)', &
      'const hole = value_at(p, ''hole'', bit), y_of = v => T / 2 - v / hole * 150, off = d => value_at(p, ''displace'// &
      'ment'', d) * Math.cos(angle(p, d))', &
      'const edge = (from, to, v_of) => Array.from({length: 81}, (_, i) => from + (to - from) * i / 80).map(d => `${x'// &
      '_of(d).toFixed(1)} ${y_of(v_of(d)).toFixed(1)}`)', &
      'const write = writer(assembly, W)', &
      'for (const side of [.5, -.5]) make(assembly, ''path'', {d: ''M'' + edge(top, bit, d => side * value_at(p, ''ho'// &
      'le'', d)).join(''L''), class: ''wall''})', &
      'for (const part of D.cases[p.case].parts) {', &
      'const from = Math.max(bit - part.to, top), to = bit - part.from', &
      'if (to <= top) continue', &
      'const body = [...edge(from, to, d => off(d) + part.od / 2), ...edge(to, from, d => off(d) - part.od / 2)]', &
      'make(make(assembly, ''path'', {d: ''M'' + body.join(''L'') + ''z'', class: ''body''}), ''title'', {}, part.nam'// &
      'e)', &
      'write((x_of(from) + x_of(to)) / 2, 14, part.name)', &
      '}', &
      'for (const t of ticks(0, shown_length * factor(''length''), W / 120)) write(x_of(bit - t / factor(''length''))'// &
      ', T - 4, String(t))', &
      'const contacts = (p.contacts ?? []).filter(c => c[0] > top).sort((a, b) => b[1] - a[1])', &
      'for (const [d, force, clock] of contacts) {', &
      'const side = Math.cos(clock * Math.PI / 180) < 0 ? -1 : 1, y2 = y_of(side * hole / 2), y1 = y2 - side * (8 + 2'// &
      '0 * force / contacts[0][1])', &
      'make(assembly, ''line'', {x1: x_of(d), x2: x_of(d), y1, y2, class: ''force''})', &
      'write(x_of(d), side < 0 ? T - 24 : 36, text_of(force, ''force''))', &
      '}', &
      'scale.textContent = `The lowest ${round_text(shown_length)}: distance above the bit [${unit(''length'')}], con'// &
      'tact forces [${unit(''force'')}], enlarged across the hole.`', &
      '}', &
      'for (const n in D.columns) if (!D.columns[n].words) make(pick, ''h:option'', {value: n}, D.columns[n].label)', &
      'pick.value = state.tint', &
      'well.before(pick)', &
      'const turn_by = (x, y) => { state.yaw += x; state.pitch = Math.min(1.5, Math.max(-1.5, state.pitch + y)); draw'// &
      '_well() }', &
      'const sides = {''3D'': [-0.6, 0.35], plan: [0, Math.PI / 2], ''from south'': [0, 0], ''from east'': [-Math.PI '// &
      '/ 2, 0]}', &
      'for (const name in sides) well.before(make(null, ''h:button'', {type: ''button'', onclick: () => { [state.yaw,'// &
      ' state.pitch] = sides[name]; draw_well() }}, name))', &
      'well.addEventListener(''pointermove'', e => { if (e.buttons) turn_by(e.movementX / 150, e.movementY / 150) })', &
      'well.addEventListener(''wheel'', e => { e.preventDefault(); state.near *= e.deltaY < 0 ? 1.15 : 1 / 1.15; draw'// &
      '_well() }, {passive: false})', &
      'well.addEventListener(''keydown'', e => {', &
      'const by = {ArrowLeft: [-.1, 0], ArrowRight: [.1, 0], ArrowUp: [0, -.1], ArrowDown: [0, .1]}[e.key]', &
      'if (by) { e.preventDefault(); turn_by(...by) }', &
      '})', &
      'return {draw: () => { draw_well(); draw_assembly() }, mark: () => { mark_well(); draw_section() }}', &
      '}']
   character(185), parameter :: script_lines(486) = [ &
      script_lines_1, &
      script_lines_2, &
      script_lines_3, &
      script_lines_4, &
      script_lines_5]
   character(284), parameter :: style_lines_1(31) = [character(284) :: &
      '.scripted .static{display:none}', &
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
      '.main{display:grid;grid-template-columns:11em minmax(0,1fr);gap:1em}.side{font-size:.85em}.side select{display'// &
      ':block;width:100%;font:inherit;color:inherit;background:none;border:1px solid #888}', &
      '.legend button{overflow-wrap:anywhere}.readout th{max-width:9em}.panel div{font-size:11px;line-height:1.2}', &
      '.panels{display:flex;flex-wrap:wrap;touch-action:pan-y;user-select:none;cursor:crosshair}', &
      '.right input[type=range]{width:100%}.hint{font-size:.8em;margin:.2em 0}.lower{display:grid;grid-template-colum'// &
      'ns:13em 1fr;gap:1em}.lower figure{max-width:640px}', &
      ':focus-visible{outline:3px solid #E69F00}', &
      '@media screen and (max-width:700px){.lower figure:first-child{max-width:12em;margin:0 auto}.live figure{margin'// &
      ':1em 0}.main,.lower{grid-template-columns:minmax(0,1fr)}}', &
      '@media screen and (prefers-color-scheme:dark){.live{--ink:#dde2e6;--line:#2f363d;--soft:#8a939b;--paper:#14181'// &
      'c;--wall:#b8935f;--steel:#46525b}.live svg{filter:none}}', &
      '@media screen{.first{display:none}.lead{display:flex;flex-direction:column}.lead .head{order:1}.head p{margin:'// &
      '.3em 0}.head h3{margin:.8em 0 .2em}}', &
      '.more{display:none}', &
      '.lead p{margin:.4em 0}caption{text-align:left;padding:.2em 0}', &
      '.live>div+div .bar{display:none}.hint{display:none}.scripted .hint{display:block}', &
      '@media print{.live .panels{flex-wrap:nowrap}.live svg.panel{width:0!important;flex:1 1 0}.bar,.side,.scripted '// &
      '.hint,.live input,.live label,.live .lower,.live .readout,.live .cross,.live .band,details:not([open]){display'// &
      ':none!important}', &
      '.main{display:block}.right{break-inside:avoid}.live figure svg{max-height:60mm}.live svg.panel{max-height:none'// &
      '}.legend button{border:none;padding:0 .7em 0 0}', &
      '.head{display:grid;grid-template-columns:2fr 3fr;gap:6mm;break-inside:avoid}.head p{margin:.2em 0;font-size:8.'// &
      '5pt}.head h3{margin:0}.first{font-size:8.5pt}.lead h2{margin-top:.6em}.legend{gap:0}', &
      '.lead{display:flex;flex-direction:column}.lead .wide,.answers,.answers tbody{display:contents}', &
      '.answers tr{display:grid;grid-template-columns:14em 4em 1fr;font-size:8pt;padding:.1em .4em;border-bottom:1px '// &
      'solid #ddd;break-inside:avoid}.answers td{padding:0;border:none}', &
      '.answers .more{break-after:avoid;order:8;font-weight:600}.more td{grid-column:1/-1}.lead .note{order:9}', &
      'h1{font-size:14pt;margin:0}h1+p{margin:.2em 0}.lead .note{font-size:8pt;margin:.4em 0;padding:.1em .8em}.lead '// &
      'h2{font-size:11pt}}']
   character(284), parameter :: style_lines(31) = [ &
      style_lines_1]
end module dg_page_script
