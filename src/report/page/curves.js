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
