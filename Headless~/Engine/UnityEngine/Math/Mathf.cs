using System;

namespace UnityEngine
{
    public struct Mathf
    {
        public const float PI = MathF.PI;
        public const float Infinity = float.PositiveInfinity;
        public const float NegativeInfinity = float.NegativeInfinity;
        public const float Deg2Rad = PI * 2 / 360;
        public const float Rad2Deg = 1 / Deg2Rad;
        public static readonly float Epsilon = float.Epsilon;

        public static float Sin(float f) => MathF.Sin(f);
        public static float Cos(float f) => MathF.Cos(f);
        public static float Tan(float f) => MathF.Tan(f);
        public static float Asin(float f) => MathF.Asin(f);
        public static float Acos(float f) => MathF.Acos(f);
        public static float Atan(float f) => MathF.Atan(f);
        public static float Atan2(float y, float x) => MathF.Atan2(y, x);
        public static float Sqrt(float f) => MathF.Sqrt(f);
        public static float Abs(float f) => MathF.Abs(f);
        public static int Abs(int value) => Math.Abs(value);
        public static float Pow(float f, float p) => MathF.Pow(f, p);
        public static float Exp(float power) => MathF.Exp(power);
        public static float Log(float f, float p) => (float)Math.Log(f, p);
        public static float Log(float f) => MathF.Log(f);
        public static float Log10(float f) => MathF.Log10(f);
        public static float Ceil(float f) => MathF.Ceiling(f);
        public static float Floor(float f) => MathF.Floor(f);
        public static float Round(float f) => MathF.Round(f);
        public static int CeilToInt(float f) => (int)Math.Ceiling((double)f);
        public static int FloorToInt(float f) => (int)Math.Floor((double)f);
        public static int RoundToInt(float f) => (int)Math.Round((double)f);
        public static float Sign(float f) => f >= 0 ? 1 : -1;

        // Not Math.Min and Max: a NaN on the left loses here, as Unity has it.
        public static float Min(float a, float b) => a < b ? a : b;
        public static int Min(int a, int b) => a < b ? a : b;
        public static float Max(float a, float b) => a > b ? a : b;
        public static int Max(int a, int b) => a > b ? a : b;

        public static float Min(params float[] values)
        {
            if (values.Length == 0) return 0;
            float result = values[0];
            for (int i = 1; i < values.Length; i++) result = Min(values[i], result);
            return result;
        }

        public static int Min(params int[] values)
        {
            if (values.Length == 0) return 0;
            int result = values[0];
            for (int i = 1; i < values.Length; i++) result = Min(values[i], result);
            return result;
        }

        public static float Max(params float[] values)
        {
            if (values.Length == 0) return 0;
            float result = values[0];
            for (int i = 1; i < values.Length; i++) result = Max(values[i], result);
            return result;
        }

        public static int Max(params int[] values)
        {
            if (values.Length == 0) return 0;
            int result = values[0];
            for (int i = 1; i < values.Length; i++) result = Max(values[i], result);
            return result;
        }

        public static float Clamp(float value, float min, float max) => value < min ? min : value > max ? max : value;
        public static int Clamp(int value, int min, int max) => value < min ? min : value > max ? max : value;
        public static float Clamp01(float value) => value < 0 ? 0 : value > 1 ? 1 : value;
        public static float Lerp(float a, float b, float t) => a + (b - a) * Clamp01(t);
        public static float LerpUnclamped(float a, float b, float t) => a + (b - a) * t;
        public static float InverseLerp(float a, float b, float value) => a != b ? Clamp01((value - a) / (b - a)) : 0;

        public static float SmoothStep(float from, float to, float t)
        {
            t = Clamp01(t);
            t = t * t * (3 - 2 * t);
            return to * t + from * (1 - t);
        }

        public static float Repeat(float t, float length) => Clamp(t - MathF.Floor(t / length) * length, 0, length);
        public static float PingPong(float t, float length) => length - Abs(Repeat(t, length * 2) - length);

        public static float DeltaAngle(float current, float target)
        {
            float delta = Repeat(target - current, 360);
            return delta > 180 ? delta - 360 : delta;
        }

        public static float LerpAngle(float a, float b, float t) => a + DeltaAngle(a, b) * Clamp01(t);
        public static float MoveTowards(float current, float target, float maxDelta)
            => Abs(target - current) <= maxDelta ? target : current + Sign(target - current) * maxDelta;

        public static float MoveTowardsAngle(float current, float target, float maxDelta)
        {
            float delta = DeltaAngle(current, target);
            return -maxDelta < delta && delta < maxDelta ? target : MoveTowards(current, current + delta, maxDelta);
        }

        public static float Gamma(float value, float absmax, float gamma)
        {
            float abs = Abs(value);
            if (abs > absmax)
                return value;
            float result = Pow(abs / absmax, gamma) * absmax;
            return value < 0 ? -result : result;
        }

        public static bool Approximately(float a, float b) => Abs(b - a) < Max(1e-6f * Max(Abs(a), Abs(b)), Epsilon * 8);

        public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime)
            => SmoothDamp(current, target, ref currentVelocity, smoothTime, Infinity, Time.deltaTime);

        public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed)
            => SmoothDamp(current, target, ref currentVelocity, smoothTime, maxSpeed, Time.deltaTime);

        /// <summary>A critically damped spring that never overshoots.</summary>
        public static float SmoothDamp(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed, float deltaTime)
        {
            smoothTime = Max(0.0001f, smoothTime);
            float omega = 2 / smoothTime;
            float decay = SpringDecay(omega * deltaTime);
            float change = Clamp(current - target, -maxSpeed * smoothTime, maxSpeed * smoothTime);
            float goal = current - change;
            float pull = (currentVelocity + omega * change) * deltaTime;
            currentVelocity = (currentVelocity - omega * pull) * decay;
            float next = goal + (change + pull) * decay;
            if (target - current > 0 == next > target)
            {
                next = target;
                currentVelocity = deltaTime > 0 ? (next - target) / deltaTime : 0;
            }
            return next;
        }

        // exp(-x) as a rational function, the usual one for this spring (Game Programming Gems 4, 1.10).
        internal static float SpringDecay(float x) => 1 / (1 + x + 0.48f * x * x + 0.235f * x * x * x);

        public static float SmoothDampAngle(float current, float target, ref float currentVelocity, float smoothTime)
            => SmoothDampAngle(current, target, ref currentVelocity, smoothTime, Infinity, Time.deltaTime);

        public static float SmoothDampAngle(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed)
            => SmoothDampAngle(current, target, ref currentVelocity, smoothTime, maxSpeed, Time.deltaTime);

        public static float SmoothDampAngle(float current, float target, ref float currentVelocity, float smoothTime, float maxSpeed, float deltaTime)
            => SmoothDamp(current, current + DeltaAngle(current, target), ref currentVelocity, smoothTime, maxSpeed, deltaTime);

        public static bool IsPowerOfTwo(int value) => value > 0 && (value & (value - 1)) == 0;

        public static int NextPowerOfTwo(int value)
        {
            uint v = (uint)value - 1;
            v |= v >> 1; v |= v >> 2; v |= v >> 4; v |= v >> 8; v |= v >> 16;
            return (int)(v + 1);
        }

        public static int ClosestPowerOfTwo(int value)
        {
            int next = NextPowerOfTwo(value), previous = next >> 1;
            return value - previous < next - value ? previous : next;
        }

        public static float GammaToLinearSpace(float value)
            => value <= 0.04045f ? value / 12.92f : value < 1 ? MathF.Pow((value + 0.055f) / 1.055f, 2.4f) : MathF.Pow(value, 2.2f);

        public static float LinearToGammaSpace(float value)
            => value <= 0 ? 0 : value <= 0.0031308f ? value * 12.92f : value < 1 ? 1.055f * MathF.Pow(value, 1 / 2.4f) - 0.055f
                : MathF.Pow(value, 1 / 2.2f);

        /// <summary>IEEE half, rounded to nearest even.</summary>
        public static ushort FloatToHalf(float val)
        {
            uint bits = (uint)BitConverter.SingleToInt32Bits(val);
            uint sign = bits >> 16 & 0x8000, magnitude = bits & 0x7FFFFFFF;
            if (magnitude > 0x7F800000) return (ushort)(sign | 0x7E00);
            if (magnitude >= 0x47800000) return (ushort)(sign | 0x7C00);
            if (magnitude < 0x38800000)
            {
                // Subnormal: adding 0.5 leaves the rounded bits at the bottom of the mantissa.
                float aligned = BitConverter.Int32BitsToSingle((int)magnitude) + 0.5f;
                return (ushort)(sign | (uint)(BitConverter.SingleToInt32Bits(aligned) - 0x3F000000));
            }
            return (ushort)(sign | (magnitude - 0x38000000 + 0xFFF + (magnitude >> 13 & 1)) >> 13);
        }

        public static float HalfToFloat(ushort val)
        {
            uint sign = (uint)(val & 0x8000) << 16, exponent = (uint)(val >> 10 & 31), mantissa = (uint)(val & 0x3FF);
            if (exponent == 0)
                return (sign != 0 ? -1 : 1) * (mantissa / 16777216f);
            exponent = exponent == 31 ? 255 : exponent + 112;
            return BitConverter.Int32BitsToSingle((int)(sign | exponent << 23 | mantissa << 13));
        }

        public static float PerlinNoise1D(float x) => PerlinNoise(x, 0);

        /// <summary>Classic gradient noise, about 0 to 1, 0.5 at whole numbers. Not bit for bit Unity's.</summary>
        public static float PerlinNoise(float x, float y)
        {
            x = Abs(x);
            y = Abs(y);
            int ix = FloorToInt(x), iy = FloorToInt(y);
            float fx = x - ix, fy = y - iy;
            float u = Fade(fx), v = Fade(fy);
            float low = LerpUnclamped(Slope(ix, iy, fx, fy), Slope(ix + 1, iy, fx - 1, fy), u);
            float high = LerpUnclamped(Slope(ix, iy + 1, fx, fy - 1), Slope(ix + 1, iy + 1, fx - 1, fy - 1), u);
            return (LerpUnclamped(low, high, v) + 0.69f) / 1.483f;

            static float Fade(float t) => t * t * t * (t * (t * 6 - 15) + 10);

            static float Slope(int cellX, int cellY, float dx, float dy)
            {
                uint h = (uint)cellX * 0x8DA6B343u ^ (uint)cellY * 0xD8163841u;
                h = (h ^ h >> 15) * 0x2C1B3C6Du;
                h ^= h >> 12;
                float angle = (h & 0xFF) * (2 * PI / 256);
                return MathF.Cos(angle) * dx + MathF.Sin(angle) * dy;
            }
        }

        /// <summary>A black body's color, by Helland's fit; kelvin from 1000 to 40000.</summary>
        public static Color CorrelatedColorTemperatureToRGB(float kelvin)
        {
            float t = Clamp(kelvin, 1000, 40000) / 100;
            float r = t <= 66 ? 255 : 329.698727446f * Pow(t - 60, -0.1332047592f);
            float g = t <= 66 ? 99.4708025861f * Log(t) - 161.1195681661f : 288.1221695283f * Pow(t - 60, -0.0755148492f);
            float b = t >= 66 ? 255 : t <= 19 ? 0 : 138.5177312231f * Log(t - 10) - 305.0447927307f;
            return new Color(Clamp01(r / 255), Clamp01(g / 255), Clamp01(b / 255)).linear;
        }
    }
}
