using static Unity.Mathematics.math;

namespace Unity.Mathematics
{
    public partial struct float2x2
    {
        public static float2x2 Rotate(float angle)
        {
            sincos(angle, out float s, out float c);
            return new float2x2(c, -s, s, c);
        }

        public static float2x2 Scale(float s) => Scale(s, s);
        public static float2x2 Scale(float2 v) => Scale(v.x, v.y);
        public static float2x2 Scale(float x, float y) => new float2x2(x, 0, 0, y);
    }

    public partial struct float3x3
    {
        public float3x3(float4x4 f4x4) : this(f4x4.c0.xyz, f4x4.c1.xyz, f4x4.c2.xyz) { }
        public float3x3(quaternion q) : this(mul(q, new float3(1, 0, 0)), mul(q, new float3(0, 1, 0)), mul(q, new float3(0, 0, 1))) { }
        public static explicit operator float3x3(float4x4 f4x4) => new float3x3(f4x4);

        public static float3x3 AxisAngle(float3 axis, float angle) => new float3x3(quaternion.AxisAngle(axis, angle));
        public static float3x3 Euler(float3 xyz, RotationOrder order = RotationOrder.Default) => new float3x3(quaternion.Euler(xyz, order));
        public static float3x3 Euler(float x, float y, float z, RotationOrder order = RotationOrder.Default) => Euler(new float3(x, y, z), order);
        public static float3x3 EulerXYZ(float3 xyz) => Euler(xyz, RotationOrder.XYZ);
        public static float3x3 EulerXZY(float3 xyz) => Euler(xyz, RotationOrder.XZY);
        public static float3x3 EulerYXZ(float3 xyz) => Euler(xyz, RotationOrder.YXZ);
        public static float3x3 EulerYZX(float3 xyz) => Euler(xyz, RotationOrder.YZX);
        public static float3x3 EulerZXY(float3 xyz) => Euler(xyz, RotationOrder.ZXY);
        public static float3x3 EulerZYX(float3 xyz) => Euler(xyz, RotationOrder.ZYX);
        public static float3x3 RotateX(float angle) => new float3x3(quaternion.RotateX(angle));
        public static float3x3 RotateY(float angle) => new float3x3(quaternion.RotateY(angle));
        public static float3x3 RotateZ(float angle) => new float3x3(quaternion.RotateZ(angle));
        public static float3x3 Scale(float s) => Scale(s, s, s);
        public static float3x3 Scale(float3 v) => Scale(v.x, v.y, v.z);
        public static float3x3 Scale(float x, float y, float z) => new float3x3(x, 0, 0, 0, y, 0, 0, 0, z);

        public static float3x3 LookRotation(float3 forward, float3 up)
        {
            float3 x = normalize(cross(up, forward));
            return new float3x3(x, cross(forward, x), forward);
        }

        public static float3x3 LookRotationSafe(float3 forward, float3 up) => new float3x3(quaternion.LookRotationSafe(forward, up));
    }

    public partial struct float4x4
    {
        public float4x4(float3x3 rotation, float3 translation)
            : this(new float4(rotation.c0, 0), new float4(rotation.c1, 0), new float4(rotation.c2, 0), new float4(translation, 1)) { }
        public float4x4(quaternion rotation, float3 translation) : this(new float3x3(rotation), translation) { }

        public static float4x4 TRS(float3 translation, quaternion rotation, float3 scale)
        {
            float3x3 r = new float3x3(rotation);
            return new float4x4(new float3x3(r.c0 * scale.x, r.c1 * scale.y, r.c2 * scale.z), translation);
        }

        public static float4x4 Translate(float3 vector) => new float4x4(float3x3.identity, vector);
        public static float4x4 Scale(float s) => Scale(s, s, s);
        public static float4x4 Scale(float3 scales) => Scale(scales.x, scales.y, scales.z);
        public static float4x4 Scale(float x, float y, float z) => new float4x4(float3x3.Scale(x, y, z), default);
        public static float4x4 AxisAngle(float3 axis, float angle) => new float4x4(float3x3.AxisAngle(axis, angle), default);
        public static float4x4 Euler(float3 xyz, RotationOrder order = RotationOrder.Default) => new float4x4(float3x3.Euler(xyz, order), default);
        public static float4x4 Euler(float x, float y, float z, RotationOrder order = RotationOrder.Default) => Euler(new float3(x, y, z), order);
        public static float4x4 EulerXYZ(float3 xyz) => Euler(xyz, RotationOrder.XYZ);
        public static float4x4 EulerZXY(float3 xyz) => Euler(xyz, RotationOrder.ZXY);
        public static float4x4 RotateX(float angle) => new float4x4(float3x3.RotateX(angle), default);
        public static float4x4 RotateY(float angle) => new float4x4(float3x3.RotateY(angle), default);
        public static float4x4 RotateZ(float angle) => new float4x4(float3x3.RotateZ(angle), default);

        /// <summary>Puts an object at eye, its z axis to the target.</summary>
        public static float4x4 LookAt(float3 eye, float3 target, float3 up) => new float4x4(float3x3.LookRotation(normalize(target - eye), up), eye);

        // OpenGL's clip space: -1 to 1, looking down -z.
        public static float4x4 Ortho(float width, float height, float near, float far)
            => OrthoOffCenter(-width / 2, width / 2, -height / 2, height / 2, near, far);
        public static float4x4 OrthoOffCenter(float left, float right, float bottom, float top, float near, float far)
            => UnityEngine.Matrix4x4.Ortho(left, right, bottom, top, near, far);
        public static float4x4 PerspectiveFov(float verticalFov, float aspect, float near, float far)
            => UnityEngine.Matrix4x4.Perspective(math.degrees(verticalFov), aspect, near, far);
        public static float4x4 PerspectiveOffCenter(float left, float right, float bottom, float top, float near, float far)
            => UnityEngine.Matrix4x4.Frustum(left, right, bottom, top, near, far);
    }
}
