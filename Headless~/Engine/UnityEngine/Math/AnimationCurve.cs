using System;
using System.Collections.Generic;
using System.Linq;

namespace UnityEngine
{
    /// <summary>Keys joined by cubic Hermite segments, or by Bezier segments where tangents carry weights.</summary>
    public class AnimationCurve : IEquatable<AnimationCurve>
    {
        readonly List<Keyframe> list = new List<Keyframe>();

        public AnimationCurve() { }
        public AnimationCurve(params Keyframe[] keys) { this.keys = keys; }

        public WrapMode preWrapMode { get; set; } = WrapMode.ClampForever;
        public WrapMode postWrapMode { get; set; } = WrapMode.ClampForever;
        public int length => list.Count;
        public Keyframe this[int index] => list[index];

        public Keyframe[] keys
        {
            get => list.ToArray();
            set
            {
                list.Clear();
                if (value != null)
                    foreach (Keyframe key in value)
                        AddKey(key);
            }
        }

        public static AnimationCurve Constant(float timeStart, float timeEnd, float value) => Linear(timeStart, value, timeEnd, value);

        public static AnimationCurve Linear(float timeStart, float valueStart, float timeEnd, float valueEnd)
        {
            if (timeStart == timeEnd)
                return new AnimationCurve(new Keyframe(timeStart, valueStart));
            float slope = (valueEnd - valueStart) / (timeEnd - timeStart);
            return new AnimationCurve(new Keyframe(timeStart, valueStart, 0, slope), new Keyframe(timeEnd, valueEnd, slope, 0));
        }

        public static AnimationCurve EaseInOut(float timeStart, float valueStart, float timeEnd, float valueEnd)
            => timeStart == timeEnd ? new AnimationCurve(new Keyframe(timeStart, valueStart))
            : new AnimationCurve(new Keyframe(timeStart, valueStart, 0, 0), new Keyframe(timeEnd, valueEnd, 0, 0));

        /// <summary>-1 when there is a key at that time already.</summary>
        public int AddKey(Keyframe key)
        {
            int at = list.FindIndex(k => k.time >= key.time);
            if (at < 0)
                at = list.Count;
            else if (list[at].time == key.time)
                return -1;
            list.Insert(at, key);
            return at;
        }

        /// <summary>With smooth tangents.</summary>
        public int AddKey(float time, float value)
        {
            int at = AddKey(new Keyframe(time, value));
            if (at < 0)
                return at;
            for (int i = Math.Max(0, at - 1); i <= Math.Min(length - 1, at + 1); i++)
                SmoothTangents(i, 0);
            return at;
        }

        public int MoveKey(int index, Keyframe key)
        {
            list.RemoveAt(index);
            return AddKey(key);
        }

        public void RemoveKey(int index) => list.RemoveAt(index);
        public void ClearKeys() => list.Clear();

        public void SmoothTangents(int index, float weight)
        {
            Keyframe key = list[index];
            if (length < 2)
                return;
            float before = index > 0 ? Slope(index - 1) : Slope(index);
            float after = index < length - 1 ? Slope(index) : Slope(index - 1);
            key.inTangent = key.outTangent = before * (1 + weight) * 0.5f + after * (1 - weight) * 0.5f;
            list[index] = key;
        }

        float Slope(int i) => (list[i + 1].value - list[i].value) / (list[i + 1].time - list[i].time);

        public void CopyFrom(AnimationCurve other)
        {
            list.Clear();
            list.AddRange(other.list);
            preWrapMode = other.preWrapMode;
            postWrapMode = other.postWrapMode;
        }

        public float Evaluate(float time)
        {
            if (length == 0)
                return 0;
            if (length == 1)
                return list[0].value;
            float first = list[0].time, last = list[length - 1].time;
            if (time < first)
                time = Wrap(time, first, last, preWrapMode);
            else if (time > last)
                time = Wrap(time, first, last, postWrapMode);
            if (time <= first)
                return list[0].value;
            if (time >= last)
                return list[length - 1].value;

            int low = 0, high = length - 1;
            while (high - low > 1)
            {
                int mid = (low + high) / 2;
                if (list[mid].time <= time) low = mid;
                else high = mid;
            }
            return Segment(list[low], list[high], time);
        }

        static float Wrap(float time, float first, float last, WrapMode mode) => mode switch
        {
            WrapMode.Loop => first + Mathf.Repeat(time - first, last - first),
            WrapMode.PingPong => first + Mathf.PingPong(time - first, last - first),
            _ => Mathf.Clamp(time, first, last),
        };

        static float Segment(in Keyframe a, in Keyframe b, float time)
        {
            // An infinite tangent holds the value until the next key.
            if (float.IsInfinity(a.outTangent) || float.IsInfinity(b.inTangent))
                return a.value;
            float span = b.time - a.time, s = (time - a.time) / span;
            bool weighted = (a.weightedMode & WeightedMode.Out) != 0 || (b.weightedMode & WeightedMode.In) != 0;
            if (!weighted)
            {
                float s2 = s * s, s3 = s2 * s;
                return (2 * s3 - 3 * s2 + 1) * a.value + (s3 - 2 * s2 + s) * span * a.outTangent
                    + (s3 - s2) * span * b.inTangent + (-2 * s3 + 3 * s2) * b.value;
            }

            float x1 = (a.weightedMode & WeightedMode.Out) != 0 ? a.outWeight : 1f / 3;
            float w2 = (b.weightedMode & WeightedMode.In) != 0 ? b.inWeight : 1f / 3;
            float y1 = a.value + x1 * span * a.outTangent, y2 = b.value - w2 * span * b.inTangent, x2 = 1 - w2;
            // x(u) rises over [0, 1], so bisection always finds the parameter.
            float lower = 0, upper = 1, u = s;
            for (int i = 0; i < 32; i++)
            {
                u = (lower + upper) * 0.5f;
                if (Bezier(0, x1, x2, 1, u) < s) lower = u;
                else upper = u;
            }
            return Bezier(a.value, y1, y2, b.value, u);
        }

        static float Bezier(float p0, float p1, float p2, float p3, float u)
        {
            float v = 1 - u;
            return v * v * v * p0 + 3 * v * v * u * p1 + 3 * v * u * u * p2 + u * u * u * p3;
        }

        public bool Equals(AnimationCurve other)
            => other != null && preWrapMode == other.preWrapMode && postWrapMode == other.postWrapMode && list.SequenceEqual(other.list);
        public override bool Equals(object o) => Equals(o as AnimationCurve);
        public override int GetHashCode() => HashCode.Combine(length, preWrapMode, postWrapMode);
    }

    public struct Keyframe
    {
        float m_Time;
        float m_Value;
        float m_InTangent;
        float m_OutTangent;
        WeightedMode m_WeightedMode;
        float m_InWeight;
        float m_OutWeight;

        public Keyframe(float time, float value) : this(time, value, 0, 0) { }

        public Keyframe(float time, float value, float inTangent, float outTangent)
        {
            m_Time = time;
            m_Value = value;
            m_InTangent = inTangent;
            m_OutTangent = outTangent;
            m_WeightedMode = WeightedMode.None;
            m_InWeight = m_OutWeight = 0;
        }

        public Keyframe(float time, float value, float inTangent, float outTangent, float inWeight, float outWeight)
            : this(time, value, inTangent, outTangent)
        {
            m_WeightedMode = WeightedMode.Both;
            m_InWeight = inWeight;
            m_OutWeight = outWeight;
        }

        public float time { get => m_Time; set => m_Time = value; }
        public float value { get => m_Value; set => m_Value = value; }
        public float inTangent { get => m_InTangent; set => m_InTangent = value; }
        public float outTangent { get => m_OutTangent; set => m_OutTangent = value; }
        public float inWeight { get => m_InWeight; set => m_InWeight = value; }
        public float outWeight { get => m_OutWeight; set => m_OutWeight = value; }
        public WeightedMode weightedMode { get => m_WeightedMode; set => m_WeightedMode = value; }
    }

    [Flags] public enum WeightedMode { None = 0, In = 1, Out = 2, Both = 3 }
    public enum WrapMode { Default = 0, Once = 1, Clamp = 1, Loop = 2, PingPong = 4, ClampForever = 8 }
}
