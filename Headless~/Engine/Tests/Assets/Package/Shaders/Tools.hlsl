uint Twice(uint value) { return value * 2; }
