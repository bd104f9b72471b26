// Curves of the page's data, as page_curves.f90 and page_code.f90 write them: depths d and values v.
function level_of(code) {                                    // a digit of base 90, see page_code.f90
   return code - 35 - (code > 60) - (code > 92)
}
function depths_of(text) {                                   // steps in thousandths of D.units' length, less the last step
   const d = []
   for (let i = 0, sum = 0, step = 0, n = 0; i < text.length; i++) {
      const digit = level_of(text.charCodeAt(i))
      n = n * 45 + digit % 45
      if (digit < 45) { d.push((sum += step += n % 2 ? -(n + 1) / 2 : n / 2) / 1000); n = 0 }
   }
   return Float64Array.from(d)
}
function group_of(levels) {                                  // digits of a group, levels in it: the fewest digits a level
   let length = 1, number = 0
   for (let i = 1; i <= 8; i++) {
      let n = 0
      for (let power = levels; power <= 90 ** i; power *= levels) n++
      if (n * length > number * i) [length, number] = [i, n]
   }
   return [length, number]
}
function values_of(text, first, step, count, levels) {       // the last level: no value
   const v = new Float64Array(count), [length, number] = levels ? group_of(levels) : [text.length / count, 1], all = levels ?? 90 ** length
   for (let i = 0; i < count; i += number) {
      const at = i / number * length
      let group = 0
      for (let k = at; k < at + length; k++) group = group * 90 + level_of(text.charCodeAt(k))
      for (let k = i + number - 1; k >= i; k--) {
         const level = group % all
         group = (group - level) / all
         if (k < count) v[k] = levels || length < 4 ? (first + level) * step : (Math.floor(level / 90) - 364500) * 10 ** (level % 90 - 45)
         if (k < count && level === all - 1) v[k] = NaN
      }
   }
   return v
}
function curve_of(written, rows) {                           // depths: their own, shared ones (0: all), or even ones
   const [first, step, depths, values, levels] = written ?? [0, 1, '', '']
   const even = ([from, to, n]) => Float64Array.from({length: n + 1}, (_, i) => from + i / n * (to - from))
   const has = (bits, i) => level_of(bits.charCodeAt(Math.floor(i / 6))) >> (5 - i % 6) & 1
   const places = ([text, bits]) => bits ? rows.filter((_, i) => has(bits, i)) : depths_of(text).map(i => rows[Math.round(1000 * i)])
   const d = depths === 0 ? rows : typeof depths === 'string' ? depths_of(depths) : depths.length < 3 ? places(depths) : even(depths)
   return {d, v: values_of(values, first, step, d.length, levels)}
}
function with_peaks(d, v, peaks) {                           // depth and value of the largest, then of the least, which are exact
   const [, most, , least] = peaks, at = [...d], made = [...v].map(value => Math.max(least, Math.min(most, value)))
   for (let k = 0; k < 4; k += 2) {
      const far = i => Math.abs(at[i] - peaks[k]) < .001 ? Math.abs(made[i] - peaks[k + 1]) : Infinity
      const near = at.findIndex(depth => depth > peaks[k] - .001), i = far(near + 1) < far(near) ? near + 1 : near
      at.splice(i, far(i) < Infinity ? 1 : 0, peaks[k])
      made.splice(i, made.length - at.length + 1, peaks[k + 1])
   }
   return {d: Float64Array.from(at), v: Float64Array.from(made)}
}
function curve_by({d, v}, peaks, pieces) {                   // from another curve: points, factor, addend of each component
   const made = new Float64Array(v.length)
   for (let k = 0, i = 0; k < pieces.length; k += 3) {
      for (const end = i + pieces[k]; i < end; i++) made[i] = v[i] * pieces[k + 1] + pieces[k + 2]
   }
   return with_peaks(d, made, peaks)
}
function sum_of(a, b, peaks) {                               // at the depths of both; of two at one depth the first is above a jump
   const d = [], v = [], next = [0, 0]
   while (next[0] < a.d.length || next[1] < b.d.length) {
      const depth = Math.min(a.d[next[0]] ?? Infinity, b.d[next[1]] ?? Infinity)
      d.push(depth)
      v.push([a, b].reduce((sum, c, k) => {
         const i = next[k], part = (depth - c.d[i - 1]) / (c.d[i] - c.d[i - 1])
         if (c.d[i] === depth) return sum + c.v[next[k]++]
         return sum + (i === c.d.length ? c.v[i - 1] : c.v[i - 1] + part * (c.v[i] - c.v[i - 1]))
      }, 0))
   }
   return with_peaks(d, v, peaks)
}
function inverse_of({d, v}) {                                // with more points, as it is drawn straight between them
   const at = [], made = []
   for (let i = 0; i < d.length; i++) {
      const ratio = v[i] > 0 && v[i - 1] > 0 ? v[i - 1] / v[i] : 1, steps = Math.ceil(10 * Math.abs(Math.log(ratio))) || 1
      for (let k = steps - 1; k >= 0; k--) {
         const there = v[i] * ratio ** (k / steps), part = k && (there - v[i]) / (v[i - 1] - v[i])
         at.push(part ? d[i] + part * (d[i - 1] - d[i]) : d[i])
         made.push(there > 0 ? 1 / there : NaN)
      }
   }
   return {d: Float64Array.from(at), v: Float64Array.from(made), inverse: true}
}
function curve_from(p, curve, rows, inverse) {               // as it is written: by another one, by two, by its points
   const [name, ...more] = curve, two = typeof more[0] === 'string'
   if (inverse) return inverse_of(curve_from(p, curve, rows))
   if (two) return sum_of(p.curves[name], p.curves[more[0]], more.slice(1))
   return typeof name === 'string' ? curve_by(p.curves[name], more.slice(0, 4), more.slice(4)) : curve_of(curve, rows)
}
