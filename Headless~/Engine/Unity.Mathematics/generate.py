#!/usr/bin/env python3
"""Writes the vector types, the square float matrices and the component-wise functions of Unity.Mathematics.

Run in this folder; rewrites Vectors.Generated.cs, Matrices.Generated.cs and math.Generated.cs.
"""
import itertools
import re

XYZW = "xyzw"
NUMBERS = ["float", "int", "uint", "double"]
HEADER = "// Written by generate.py; change that instead.\n#pragma warning disable CS8981\nusing System;\nusing System.Globalization;\nusing System.Runtime.CompilerServices;\n\n"

# source type -> how a conversion from it is declared, per target
CONVERSIONS = {
    "float": {"bool": "explicit", "int": "implicit", "uint": "implicit", "double": "explicit"},
    "int": {"bool": "explicit", "uint": "explicit", "float": "explicit", "double": "explicit"},
    "uint": {"bool": "explicit", "int": "explicit", "float": "explicit", "double": "explicit"},
    "double": {"bool": "explicit", "int": "implicit", "uint": "implicit", "float": "implicit"},
    "bool": {},
}


def cast(target, source, value):
    if source == "bool":
        one = {"float": "1f", "double": "1.0", "int": "1", "uint": "1u"}[target]
        zero = one.replace("1", "0", 1)
        return f"{value} ? {one} : {zero}"
    return value if target == source else f"({target}){value}"


def each(n, form, sep=", "):
    """form with {c} for every component."""
    return sep.join(form.format(c=c) for c in XYZW[:n])


def partitions(n):
    """Ways to write n as a sum of sizes 1..n: the constructors from smaller vectors."""
    if n == 0:
        yield []
    for first in range(1, n + 1):
        for rest in partitions(n - first):
            yield [first] + rest


def constructors(t, n):
    """(parameters, component values) of every constructor."""
    for sizes in partitions(n):
        names, at = [], 0
        for size in sizes:
            names.append(XYZW[at:at + size])
            at += size
        parameters = ", ".join(f"{t}{len(m) if len(m) > 1 else ''} {m}" for m in names)
        values = []
        for m in names:
            values += [m] if len(m) == 1 else [f"{m}.{XYZW[i]}" for i in range(len(m))]
        yield parameters, values
    yield f"{t} v", ["v"] * n
    for source in CONVERSIONS[t]:
        yield f"{source} v", [cast(t, source, "v")] * n
        yield f"{source}{n} v", [cast(t, source, f"v.{c}") for c in XYZW[:n]]


def vector(t, n):
    v = f"{t}{n}"
    out = [f"    [Serializable]\n    public partial struct {v} : IEquatable<{v}>, IFormattable\n    {{"]
    w = out.append
    for c in XYZW[:n]:
        w(f"        public {t} {c};")
    if t != "bool":
        w(f"\n        public static readonly {v} zero;")
    w("")
    for parameters, values in constructors(t, n):
        body = " ".join(f"this.{c} = {x};" for c, x in zip(XYZW, values))
        w(f"        public {v}({parameters}) {{ {body} }}")
    w("")
    w(f"        public static implicit operator {v}({t} v) => new {v}(v);")
    for source, kind in CONVERSIONS[t].items():
        w(f"        public static {kind} operator {v}({source} v) => new {v}(v);")
        w(f"        public static {kind} operator {v}({source}{n} v) => new {v}(v);")
    w("")

    def binary(op, result, types=None):
        r = f"{result}{n}"
        for a, b in [(v, v), (v, t), (t, v)]:
            fa = "lhs.{c}" if a == v else "lhs"
            fb = "rhs.{c}" if b == v else "rhs"
            w(f"        public static {r} operator {op}({a} lhs, {b} rhs) => new {r}({each(n, fa + ' ' + op + ' ' + fb)});")

    if t != "bool":
        for op in "+-*/%":
            binary(op, t)
        for op in ["<", "<=", ">", ">="]:
            binary(op, "bool")
        sign = "({t})(-{{c}})".format(t=t) if t == "uint" else "-{c}"
        w(f"        public static {v} operator +({v} val) => val;")
        w(f"        public static {v} operator -({v} val) => new {v}({each(n, sign.replace('{c}', 'val.{c}'))});")
        w(f"        public static {v} operator ++({v} val) => new {v}({each(n, 'val.{c} + 1')});")
        w(f"        public static {v} operator --({v} val) => new {v}({each(n, 'val.{c} - 1')});")
    if t in ("int", "uint", "bool"):
        for op in "&|^":
            binary(op, t)
    if t in ("int", "uint"):
        w(f"        public static {v} operator ~({v} val) => new {v}({each(n, '~val.{c}')});")
        w(f"        public static {v} operator <<({v} x, int n) => new {v}({each(n, 'x.{c} << n')});")
        w(f"        public static {v} operator >>({v} x, int n) => new {v}({each(n, 'x.{c} >> n')});")
    if t == "bool":
        w(f"        public static {v} operator !({v} val) => new {v}({each(n, '!val.{c}')});")
    binary("==", "bool")
    binary("!=", "bool")

    w("")
    cases = " ".join(f"{i} => {c}," for i, c in enumerate(XYZW[:n]))
    sets = " ".join(f"case {i}: {c} = value; break;" for i, c in enumerate(XYZW[:n]))
    refuse = f'throw new ArgumentException($"{v} has components 0 to {n - 1}, not {{index}}.")'
    w(f"        public {t} this[int index]\n        {{")
    w(f"            get => index switch {{ {cases} _ => {refuse} }};")
    w(f"            set {{ switch (index) {{ {sets} default: {refuse}; }} }}\n        }}\n")

    for size in (2, 3, 4):
        for pick in itertools.product(XYZW[:n], repeat=size):
            name = "".join(pick)
            get = f"new {t}{size}({', '.join(pick)})"
            if len(set(pick)) == size:
                assign = " ".join(f"{c} = value.{XYZW[i]};" for i, c in enumerate(pick))
                w(f"        public {t}{size} {name} {{ get => {get}; set {{ {assign} }} }}")
            else:
                w(f"        public {t}{size} {name} => {get};")

    w("")
    w(f"        public bool Equals({v} rhs) => {each(n, '{c} == rhs.{c}', ' && ')};")
    w(f"        public override bool Equals(object o) => o is {v} v && Equals(v);")
    w("        public override int GetHashCode() => (int)math.hash(this);")
    suffix = "f" if t == "float" else ""
    if t == "bool":
        w(f'        public override string ToString() => $"{v}({each(n, "{{{c}}}")})";')
        out[0] = out[0].replace(", IFormattable", "")
    else:
        w(f'        public override string ToString() => ToString(null, null);')
        w(f'        public string ToString(string format, IFormatProvider formatProvider)\n            => $"{v}({each(n, "{{{c}.ToString(format, formatProvider)}}" + suffix)})";')
    w("    }\n")
    return "\n".join(out)


def matrix(n):
    m, v, b = f"float{n}x{n}", f"float{n}", f"bool{n}x{n}"
    out = [f"    /// <summary>Columns c0 to c{n - 1}; multiplies column vectors by math.mul.</summary>\n    [Serializable]\n    public partial struct {m} : IEquatable<{m}>, IFormattable\n    {{"]
    w = out.append
    columns = [f"c{i}" for i in range(n)]

    def cols(form, sep=", "):
        return sep.join(form.format(c=c) for c in columns)

    for c in columns:
        w(f"        public {v} {c};")
    unit = ", ".join(", ".join("1f" if i == j else "0f" for j in range(n)) for i in range(n))
    w(f"\n        public static readonly {m} identity = new {m}({unit});")
    w(f"        public static readonly {m} zero;\n")
    w(f"        public {m}({', '.join(v + ' ' + c for c in columns)}) {{ {' '.join(f'this.{c} = {c};' for c in columns)} }}")
    parameters = ", ".join(f"float m{i}{j}" for i in range(n) for j in range(n))
    body = " ".join(f"c{j} = new {v}({', '.join(f'm{i}{j}' for i in range(n))});" for j in range(n))
    w(f"        public {m}({parameters}) {{ {body} }}")
    w(f"        public {m}(float v) {{ {' '.join(f'{c} = v;' for c in columns)} }}")
    w(f"        public static implicit operator {m}(float v) => new {m}(v);\n")
    for op in "+-*/%":
        for a, c in [(m, m), (m, "float"), ("float", m)]:
            fa = "lhs.{c}" if a == m else "lhs"
            fb = "rhs.{c}" if c == m else "rhs"
            w(f"        public static {m} operator {op}({a} lhs, {c} rhs) => new {m}({cols(fa + ' ' + op + ' ' + fb)});")
    w(f"        public static {m} operator +({m} val) => val;")
    w(f"        public static {m} operator -({m} val) => new {m}({cols('-val.{c}')});\n")
    cases = " ".join(f"case {i}: return ref p->c{i};" for i in range(n))
    w(f"        public unsafe ref {v} this[int index]\n        {{\n            get\n            {{")
    w(f"                if ((uint)index >= {n}) throw new ArgumentException($\"{m} has columns 0 to {n - 1}, not {{index}}.\");")
    w(f"                fixed ({v}* p = &c0) return ref p[index];\n            }}\n        }}\n")
    w(f"        public bool Equals({m} rhs) => {cols('{c}.Equals(rhs.{c})', ' && ')};")
    w(f"        public override bool Equals(object o) => o is {m} m && Equals(m);")
    w("        public override int GetHashCode() => (int)math.hash(this);")
    w("        public override string ToString() => ToString(null, null);")
    rows = ",  ".join(", ".join(f"{{c{j}.{XYZW[i]}.ToString(format, formatProvider)}}f" for j in range(n)) for i in range(n))
    w(f'        public string ToString(string format, IFormatProvider formatProvider)\n            => $"{m}({rows})";')
    w("    }\n")
    return "\n".join(out)


MINMAX = "{a} < {b}"
FLOATS = ["float", "double"]
INTS = ["int", "uint"]
# name, types, parameters, result (None = same type), scalar expression over the parameters; F is MathF or Math
COMPONENTWISE = [
    ("min", FLOATS, "x y", None, "{T}.IsNaN(y) || x < y ? x : y"),
    ("max", FLOATS, "x y", None, "{T}.IsNaN(y) || x > y ? x : y"),
    ("min", INTS, "x y", None, "x < y ? x : y"),
    ("max", INTS, "x y", None, "x > y ? x : y"),
    ("mad", NUMBERS, "mulA mulB addC", None, "mulA * mulB + addC"),
    ("clamp", NUMBERS, "valueToClamp lowerBound upperBound", None, "max(lowerBound, min(upperBound, valueToClamp))"),
    ("square", NUMBERS, "x", None, "x * x"),
    ("lerp", FLOATS, "start end t", None, "start + t * (end - start)"),
    ("unlerp", FLOATS, "start end x", None, "(x - start) / (end - start)"),
    ("remap", FLOATS, "srcStart srcEnd dstStart dstEnd x", None, "lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x))"),
    ("saturate", FLOATS, "x", None, "clamp(x, ({T})0, ({T})1)"),
    ("abs", FLOATS + ["int"], "x", None, "Math.Abs(x)"),
    ("sign", FLOATS, "x", None, "x > 0 ? 1 : x < 0 ? -1 : 0"),
    ("sign", ["int"], "x", None, "x > 0 ? 1 : x < 0 ? -1 : 0"),
    ("tan", FLOATS, "x", None, "{F}.Tan(x)"), ("tanh", FLOATS, "x", None, "{F}.Tanh(x)"),
    ("atan", FLOATS, "x", None, "{F}.Atan(x)"), ("atan2", FLOATS, "y x", None, "{F}.Atan2(y, x)"),
    ("cos", FLOATS, "x", None, "{F}.Cos(x)"), ("cosh", FLOATS, "x", None, "{F}.Cosh(x)"), ("acos", FLOATS, "x", None, "{F}.Acos(x)"),
    ("sin", FLOATS, "x", None, "{F}.Sin(x)"), ("sinh", FLOATS, "x", None, "{F}.Sinh(x)"), ("asin", FLOATS, "x", None, "{F}.Asin(x)"),
    ("floor", FLOATS, "x", None, "{F}.Floor(x)"), ("ceil", FLOATS, "x", None, "{F}.Ceiling(x)"),
    ("round", FLOATS, "x", None, "{F}.Round(x)"), ("trunc", FLOATS, "x", None, "{F}.Truncate(x)"),
    ("frac", FLOATS, "x", None, "x - {F}.Floor(x)"), ("rcp", FLOATS, "x", None, "1 / x"),
    ("pow", FLOATS, "x y", None, "{F}.Pow(x, y)"), ("exp", FLOATS, "x", None, "{F}.Exp(x)"),
    ("exp2", FLOATS, "x", None, "{F}.Pow(2, x)"), ("exp10", FLOATS, "x", None, "{F}.Pow(10, x)"),
    ("log", FLOATS, "x", None, "{F}.Log(x)"), ("log2", FLOATS, "x", None, "({T})(Math.Log(x) * 1.4426950408889634)"), ("log10", FLOATS, "x", None, "{F}.Log10(x)"),
    ("fmod", FLOATS, "x y", None, "x % y"),
    ("sqrt", FLOATS, "x", None, "{F}.Sqrt(x)"), ("rsqrt", FLOATS, "x", None, "1 / {F}.Sqrt(x)"),
    ("radians", FLOATS, "x", None, "x * ({T})0.017453292519943296"), ("degrees", FLOATS, "x", None, "x * ({T})57.29577951308232"),
    ("step", FLOATS, "threshold x", None, "x >= threshold ? 1 : 0"),
    ("smoothstep", FLOATS, "xMin xMax x", None, "Smooth(saturate((x - xMin) / (xMax - xMin)))"),
    ("isfinite", FLOATS, "x", "bool", "{T}.IsFinite(x)"), ("isinf", FLOATS, "x", "bool", "{T}.IsInfinity(x)"), ("isnan", FLOATS, "x", "bool", "{T}.IsNaN(x)"),
    ("ispow2", ["int"], "x", "bool", "x > 0 && (x & x - 1) == 0"), ("ispow2", ["uint"], "x", "bool", "x > 0 && (x & x - 1) == 0"),
    ("asint", ["float"], "x", "int", "BitConverter.SingleToInt32Bits(x)"), ("asuint", ["float"], "x", "uint", "(uint)BitConverter.SingleToInt32Bits(x)"),
    ("asfloat", ["int"], "x", "float", "BitConverter.Int32BitsToSingle(x)"), ("asfloat", ["uint"], "x", "float", "BitConverter.Int32BitsToSingle((int)x)"),
    ("asint", ["uint"], "x", "int", "(int)x"), ("asuint", ["int"], "x", "uint", "(uint)x"),
    ("countbits", ["int"], "x", "int", "countbits((uint)x)"), ("lzcnt", ["int"], "x", "int", "lzcnt((uint)x)"), ("tzcnt", ["int"], "x", "int", "tzcnt((uint)x)"),
    ("countbits", ["uint"], "x", "int", "CountBits(x)"), ("lzcnt", ["uint"], "x", "int", "LeadingZeros(x)"), ("tzcnt", ["uint"], "x", "int", "x == 0 ? 32 : CountBits((x & (uint)-(int)x) - 1)"),
    ("reversebits", ["int"], "x", None, "(int)reversebits((uint)x)"), ("reversebits", ["uint"], "x", None, "ReverseBits(x)"),
    ("ceilpow2", ["int"], "x", None, "(int)ceilpow2((uint)x)"), ("ceilpow2", ["uint"], "x", None, "Fill(x - 1) + 1"),
    ("ceillog2", ["int"], "x", "int", "32 - lzcnt((uint)x - 1)"), ("ceillog2", ["uint"], "x", "int", "32 - lzcnt(x - 1)"),
    ("floorlog2", ["int"], "x", "int", "31 - lzcnt((uint)x)"), ("floorlog2", ["uint"], "x", "int", "31 - lzcnt(x)"),
]


def functions():
    out = []
    w = out.append
    for name, types, parameters, result, expression in COMPONENTWISE:
        names = parameters.split()
        for t in types:
            r = result or t
            e = expression.replace("{T}", t).replace("{F}", "MathF" if t == "float" else "Math")
            w(f"        public static {r} {name}({', '.join(f'{t} {p}' for p in names)}) => {e};")
            for n in (2, 3, 4):
                calls = ", ".join(f"{name}({', '.join(f'{p}.{c}' for p in names)})" for c in XYZW[:n])
                w(f"        public static {r}{n} {name}({', '.join(f'{t}{n} {p}' for p in names)}) => new {r}{n}({calls});")
    for t in ("int", "uint"):
        for n in ("", 2, 3, 4):
            v = f"{t}{n}"
            left = "x << (n & 31) | {u}x >> (32 - n & 31)"
            for name, e in (("rol", "(uint)x << (n & 31) | (uint)x >> (-n & 31)"), ("ror", "(uint)x >> (n & 31) | (uint)x << (-n & 31)")):
                if n == "":
                    w(f"        public static {t} {name}({t} x, int n) => ({t})({e});")
                else:
                    w(f"        public static {v} {name}({v} x, int n) => new {v}({each(n, name + '(x.{c}, n)')});")
    for t in FLOATS:
        f = "MathF" if t == "float" else "Math"
        w(f"        public static {t} modf({t} x, out {t} i) {{ i = {f}.Truncate(x); return x - i; }}")
        w(f"        public static void sincos({t} x, out {t} s, out {t} c) {{ s = {f}.Sin(x); c = {f}.Cos(x); }}")
        w(f"        static {t} Smooth({t} t) => t * t * (3 - 2 * t);")
        w(f"        public static {t} length({t} x) => abs(x);\n        public static {t} lengthsq({t} x) => x * x;")
        w(f"        public static {t} distance({t} x, {t} y) => abs(y - x);\n        public static {t} distancesq({t} x, {t} y) => (y - x) * (y - x);")
        for n in (2, 3, 4):
            v = f"{t}{n}"
            w(f"        public static {v} modf({v} x, out {v} i) {{ i = trunc(x); return x - i; }}")
            w(f"        public static void sincos({v} x, out {v} s, out {v} c) {{ s = sin(x); c = cos(x); }}")
            w(f"        public static {v} lerp({v} start, {v} end, {t} t) => start + t * (end - start);")
            w(f"        public static {t} length({v} x) => sqrt(dot(x, x));\n        public static {t} lengthsq({v} x) => dot(x, x);")
            w(f"        public static {t} distance({v} x, {v} y) => length(y - x);\n        public static {t} distancesq({v} x, {v} y) => lengthsq(y - x);")
            w(f"        public static {v} normalize({v} x) => rsqrt(dot(x, x)) * x;")
            least = "1.175494351e-38f" if t == "float" else "2.2250738585072014e-308"
            w(f"        public static {v} normalizesafe({v} x, {v} defaultvalue = new {v}())\n        {{\n            {t} square = dot(x, x);\n            return square > {least} ? x * rsqrt(square) : defaultvalue;\n        }}")
            w(f"        public static {v} reflect({v} i, {v} n) => i - 2 * n * dot(i, n);")
            w(f"        public static {v} refract({v} i, {v} n, {t} indexOfRefraction)\n        {{\n            {t} ni = dot(n, i), k = 1 - indexOfRefraction * indexOfRefraction * (1 - ni * ni);\n            return k >= 0 ? indexOfRefraction * i - (indexOfRefraction * ni + sqrt(k)) * n : default;\n        }}")
            w(f"        public static {v} project({v} a, {v} ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;")
            w(f"        public static {v} projectsafe({v} a, {v} ontoB, {v} defaultValue = new {v}())\n        {{\n            {v} p = project(a, ontoB);\n            return all(isfinite(p)) ? p : defaultValue;\n        }}")
            w(f"        public static {v} faceforward({v} n, {v} i, {v} ng) => dot(ng, i) < 0 ? n : -n;")
        w(f"        public static {t}3 cross({t}3 x, {t}3 y) => new {t}3(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);")
    for t in NUMBERS:
        w(f"        public static {t} dot({t} x, {t} y) => x * y;")
        w(f"        public static {t} select({t} falseValue, {t} trueValue, bool test) => test ? trueValue : falseValue;")
        for n in (2, 3, 4):
            v = f"{t}{n}"
            w(f"        public static {t} dot({v} x, {v} y) => {each(n, 'x.{c} * y.{c}', ' + ')};")
            w(f"        public static {t} csum({v} x) => {each(n, 'x.{c}', ' + ')};")
            for name in ("min", "max"):
                e = "x.x"
                for c in XYZW[1:n]:
                    e = f"{name}({e}, x.{c})"
                w(f"        public static {t} c{name}({v} x) => {e};")
            w(f"        public static {v} select({v} falseValue, {v} trueValue, bool test) => test ? trueValue : falseValue;")
            w(f"        public static {v} select({v} falseValue, {v} trueValue, bool{n} test) => new {v}({each(n, 'test.{c} ? trueValue.{c} : falseValue.{c}')});")
            w(f"        public static bool any({v} x) => {each(n, 'x.{c} != 0', ' || ')};")
            w(f"        public static bool all({v} x) => {each(n, 'x.{c} != 0', ' && ')};")
    for n in (2, 3, 4):
        w(f"        public static bool any(bool{n} x) => {each(n, 'x.{c}', ' || ')};")
        w(f"        public static bool all(bool{n} x) => {each(n, 'x.{c}', ' && ')};")
    for t in NUMBERS + ["bool"]:
        for n in (2, 3, 4):
            v = f"{t}{n}"
            for parameters, _ in constructors(t, n):
                arguments = ", ".join(p.split()[1] for p in parameters.split(", "))
                w(f"        public static {v} {v}({parameters}) => new {v}({arguments});")
            if t == "bool":
                bits = each(n, "v.{c} ? 1u : 0u")
            elif t == "double":
                bits = each(n, "Fold(v.{c})")
            else:
                bits = each(n, "v.{c}" if t == "uint" else "asuint(v.{c})")
            w(f"        public static uint hash({v} v) => Hash({bits});")
    for n in (2, 3, 4):
        m, v = f"float{n}x{n}", f"float{n}"
        w(f"        public static {m} {m}({', '.join(f'{v} c{i}' for i in range(n))}) => new {m}({', '.join(f'c{i}' for i in range(n))});")
        names = [f"m{i}{j}" for i in range(n) for j in range(n)]
        w(f"        public static {m} {m}({', '.join('float ' + x for x in names)}) => new {m}({', '.join(names)});")
        w(f"        public static {m} {m}(float v) => new {m}(v);")
        w(f"        public static {m} transpose({m} v) => new {m}({', '.join(f'v.c{j}.{XYZW[i]}' for j in range(n) for i in range(n))});")
        w(f"        public static {v} mul({m} a, {v} b) => {' + '.join(f'a.c{i} * b.{XYZW[i]}' for i in range(n))};")
        w(f"        public static {v} mul({v} a, {m} b) => new {v}({', '.join(f'dot(a, b.c{i})' for i in range(n))});")
        w(f"        public static {m} mul({m} a, {m} b) => new {m}({', '.join(f'mul(a, b.c{i})' for i in range(n))});")
        w(f"        public static uint hash({m} v) => Hash({', '.join(f'hash(v.c{i})' for i in range(n))});")
    return "\n".join(out)


# As in Unity's package: without it a JIT calls a function for every cross product.
INLINED = re.compile(r"^ {8}(?=public (static (?!readonly)|\w+\())", re.M)


def write(name, body):
    body = INLINED.sub("        [MethodImpl(MethodImplOptions.AggressiveInlining)] ", body)
    with open(name, "w", newline="\n") as f:
        f.write(HEADER + "namespace Unity.Mathematics\n{\n" + body + "}\n")


write("Vectors.Generated.cs", "\n".join(vector(t, n) for t in NUMBERS + ["bool"] for n in (2, 3, 4)))
write("Matrices.Generated.cs", "\n".join(matrix(n) for n in (2, 3, 4)))
write("math.Generated.cs", "    public static partial class math\n    {\n" + functions() + "\n    }\n")
