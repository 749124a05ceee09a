// Unpacks what Python's lzma packed: a fifth smaller than what browsers unpack themselves.
// After Igor Pavlov's specification of LZMA; the names are his.
function unlzma(packed, size) {
  const out = new Uint8Array(size);
  const lc = packed[0] % 9, lp = Math.floor(packed[0] / 9) % 5, pb = Math.floor(packed[0] / 45);
  let at = 14;  // after 13 bytes of header, and one that is 0
  let range = 2 ** 32 - 1, code = 0;
  const shift = () => { code = code * 256 + packed[at++]; };
  for (let i = 0; i < 4; ++i) shift();
  function normalize() {
    if (range >= 2 ** 24) return;
    range *= 256;
    shift();
  }
  const chances = (n) => new Uint16Array(n).fill(1024);
  function bit(table, i) {
    const bound = (range >>> 11) * table[i];
    const one = code >= bound;
    if (one) {
      range -= bound;
      code -= bound;
      table[i] -= table[i] >> 5;
    } else {
      range = bound;
      table[i] += (2048 - table[i]) >> 5;
    }
    normalize();
    return one ? 1 : 0;
  }
  function direct(count) {
    let value = 0;
    for (; count > 0; --count) {
      range = Math.floor(range / 2);
      const one = code >= range;
      if (one) code -= range;
      value = 2 * value + (one ? 1 : 0);
      normalize();
    }
    return value;
  }
  function tree(table, from, bits) {
    let m = 1;
    for (let i = 0; i < bits; ++i) m = 2 * m + bit(table, from + m);
    return m - (1 << bits);
  }
  function reverse(table, from, bits) {
    let m = 1, value = 0;
    for (let i = 0; i < bits; ++i) {
      const b = bit(table, from + m);
      m = 2 * m + b;
      value |= b << i;
    }
    return value;
  }
  const lengths = () => ({choice: chances(2), low: chances(128), mid: chances(128), high: chances(256)});
  function length({choice, low, mid, high}, place) {
    if (!bit(choice, 0)) return 2 + tree(low, 8 * place, 3);
    if (!bit(choice, 1)) return 10 + tree(mid, 8 * place, 3);
    return 18 + tree(high, 0, 8);
  }
  const isMatch = chances(192), isRep = chances(12), isRepG0 = chances(12), isRepG1 = chances(12), isRepG2 = chances(12);
  const isRep0Long = chances(192), literal = chances(0x300 << (lc + lp)), slots = chances(256), special = chances(128), align = chances(16);
  const matchLengths = lengths(), repLengths = lengths();
  let state = 0, rep0 = 0, rep1 = 0, rep2 = 0, rep3 = 0;
  for (let i = 0; i < size;) {
    const place = i & ((1 << pb) - 1);
    if (!bit(isMatch, 16 * state + place)) {
      const from = 0x300 * (((i & ((1 << lp) - 1)) << lc) + ((i ? out[i - 1] : 0) >> (8 - lc)));
      let symbol = 1;
      if (state >= 7) {
        for (let match = out[i - rep0 - 1]; symbol < 256; match <<= 1) {
          const expected = (match >> 7) & 1;
          const b = bit(literal, from + ((1 + expected) << 8) + symbol);
          symbol = 2 * symbol + b;
          if (b !== expected) break;
        }
      }
      while (symbol < 256) symbol = 2 * symbol + bit(literal, from + symbol);
      out[i++] = symbol;
      state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
      continue;
    }
    let count = 1;
    if (bit(isRep, state)) {
      let long = true;
      if (!bit(isRepG0, state)) {
        long = bit(isRep0Long, 16 * state + place);
      } else {
        let distance = rep1;
        if (bit(isRepG1, state)) {
          distance = rep2;
          if (bit(isRepG2, state)) {
            distance = rep3;
            rep3 = rep2;
          }
          rep2 = rep1;
        }
        rep1 = rep0;
        rep0 = distance;
      }
      if (long) count = length(repLengths, place);
      state = state < 7 ? (long ? 8 : 9) : 11;
    } else {
      [rep1, rep2, rep3] = [rep0, rep1, rep2];
      count = length(matchLengths, place);
      state = state < 7 ? 7 : 10;
      const slot = tree(slots, 64 * Math.min(count - 2, 3), 6);
      rep0 = slot;
      if (slot >= 4) {
        const bits = (slot >> 1) - 1;
        rep0 = (2 | (slot & 1)) << bits;
        rep0 += slot < 14 ? reverse(special, rep0 - slot, bits) : (direct(bits - 4) << 4) + reverse(align, 0, 4);
      }
    }
    for (const end = Math.min(i + count, size); i < end; ++i) out[i] = out[i - rep0 - 1];
  }
  return out;
}
