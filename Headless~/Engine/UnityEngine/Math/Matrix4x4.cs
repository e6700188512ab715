using System;
using System.Globalization;

namespace UnityEngine
{
    /// <summary>Column-major in memory, mRC is row R of column C; multiplies column vectors.</summary>
    public struct Matrix4x4 : IEquatable<Matrix4x4>, IFormattable
    {
        public float m00;
        public float m10;
        public float m20;
        public float m30;
        public float m01;
        public float m11;
        public float m21;
        public float m31;
        public float m02;
        public float m12;
        public float m22;
        public float m32;
        public float m03;
        public float m13;
        public float m23;
        public float m33;

        public Matrix4x4(Vector4 column0, Vector4 column1, Vector4 column2, Vector4 column3)
        {
            m00 = column0.x; m10 = column0.y; m20 = column0.z; m30 = column0.w;
            m01 = column1.x; m11 = column1.y; m21 = column1.z; m31 = column1.w;
            m02 = column2.x; m12 = column2.y; m22 = column2.z; m32 = column2.w;
            m03 = column3.x; m13 = column3.y; m23 = column3.z; m33 = column3.w;
        }

        public static Matrix4x4 zero => default;
        public static Matrix4x4 identity => Scale(Vector3.one);

        public float this[int row, int column] { get => this[row + column * 4]; set => this[row + column * 4] = value; }

        public unsafe float this[int index]
        {
            get
            {
                if ((uint)index > 15) throw new IndexOutOfRangeException("Invalid matrix index!");
                fixed (float* m = &m00) return m[index];
            }
            set
            {
                if ((uint)index > 15) throw new IndexOutOfRangeException("Invalid matrix index!");
                fixed (float* m = &m00) m[index] = value;
            }
        }

        public Vector4 GetColumn(int index) => index switch
        {
            0 => new Vector4(m00, m10, m20, m30),
            1 => new Vector4(m01, m11, m21, m31),
            2 => new Vector4(m02, m12, m22, m32),
            3 => new Vector4(m03, m13, m23, m33),
            _ => throw new IndexOutOfRangeException("Invalid column index!"),
        };

        public Vector4 GetRow(int index) => index switch
        {
            0 => new Vector4(m00, m01, m02, m03),
            1 => new Vector4(m10, m11, m12, m13),
            2 => new Vector4(m20, m21, m22, m23),
            3 => new Vector4(m30, m31, m32, m33),
            _ => throw new IndexOutOfRangeException("Invalid row index!"),
        };

        public void SetColumn(int index, Vector4 column)
        {
            for (int row = 0; row < 4; row++)
                this[row, index] = column[row];
        }

        public void SetRow(int index, Vector4 row)
        {
            for (int column = 0; column < 4; column++)
                this[index, column] = row[column];
        }

        public Vector3 GetPosition() => new Vector3(m03, m13, m23);
        public bool isIdentity => Equals(identity);
        public Matrix4x4 transpose => Transpose(this);
        public Matrix4x4 inverse => Inverse(this);
        public float determinant => Determinant(this);

        /// <summary>Scale of the upper 3x3; a mirroring matrix gets its sign on x.</summary>
        public Vector3 lossyScale
        {
            get
            {
                Vector3 x = GetColumn(0), y = GetColumn(1), z = GetColumn(2);
                float sign = Vector3.Dot(Vector3.Cross(x, y), z) < 0 ? -1 : 1;
                return new Vector3(x.magnitude * sign, y.magnitude, z.magnitude);
            }
        }

        public Quaternion rotation
        {
            get
            {
                Vector3 z = GetColumn(2), y = GetColumn(1);
                return z.magnitude < Vector3.kEpsilon ? Quaternion.identity : Quaternion.LookRotation(z, y);
            }
        }

        /// <summary>Whether it is a translation, rotation and scale without shear.</summary>
        public bool ValidTRS()
        {
            if (m30 != 0 || m31 != 0 || m32 != 0 || m33 != 1)
                return false;
            Vector3 x = GetColumn(0), y = GetColumn(1), z = GetColumn(2);
            return Square(x, y) && Square(y, z) && Square(z, x);

            static bool Square(Vector3 a, Vector3 b) => MathF.Abs(Vector3.Dot(a, b)) <= 1e-4f * MathF.Max(1e-12f, a.magnitude * b.magnitude);
        }

        public FrustumPlanes decomposeProjection
        {
            get
            {
                FrustumPlanes planes = default;
                if (m32 != 0)
                {
                    planes.zNear = m23 / (m22 - 1);
                    planes.zFar = m23 / (m22 + 1);
                    planes.left = planes.zNear * (m02 - 1) / m00;
                    planes.right = planes.zNear * (m02 + 1) / m00;
                    planes.bottom = planes.zNear * (m12 - 1) / m11;
                    planes.top = planes.zNear * (m12 + 1) / m11;
                }
                else
                {
                    planes.zNear = (m23 + 1) / m22;
                    planes.zFar = (m23 - 1) / m22;
                    planes.left = -(m03 + 1) / m00;
                    planes.right = (1 - m03) / m00;
                    planes.bottom = -(m13 + 1) / m11;
                    planes.top = (1 - m13) / m11;
                }
                return planes;
            }
        }

        public void SetTRS(Vector3 pos, Quaternion q, Vector3 s) => this = TRS(pos, q, s);

        public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s)
        {
            Matrix4x4 m = Rotate(q);
            m.m00 *= s.x; m.m10 *= s.x; m.m20 *= s.x;
            m.m01 *= s.y; m.m11 *= s.y; m.m21 *= s.y;
            m.m02 *= s.z; m.m12 *= s.z; m.m22 *= s.z;
            m.m03 = pos.x; m.m13 = pos.y; m.m23 = pos.z;
            return m;
        }

        public static Matrix4x4 Translate(Vector3 vector)
        {
            Matrix4x4 m = identity;
            m.m03 = vector.x; m.m13 = vector.y; m.m23 = vector.z;
            return m;
        }

        public static Matrix4x4 Scale(Vector3 vector)
        {
            Matrix4x4 m = default;
            m.m00 = vector.x; m.m11 = vector.y; m.m22 = vector.z; m.m33 = 1;
            return m;
        }

        public static Matrix4x4 Rotate(Quaternion q)
        {
            float x = q.x * 2, y = q.y * 2, z = q.z * 2;
            float xx = q.x * x, yy = q.y * y, zz = q.z * z, xy = q.x * y, xz = q.x * z, yz = q.y * z, wx = q.w * x, wy = q.w * y, wz = q.w * z;
            return new Matrix4x4(
                new Vector4(1 - (yy + zz), xy + wz, xz - wy, 0),
                new Vector4(xy - wz, 1 - (xx + zz), yz + wx, 0),
                new Vector4(xz + wy, yz - wx, 1 - (xx + yy), 0),
                new Vector4(0, 0, 0, 1));
        }

        /// <summary>Puts an object at from, its z axis to the target (not a view matrix, which is the inverse of one with z flipped).</summary>
        public static Matrix4x4 LookAt(Vector3 from, Vector3 to, Vector3 up) => TRS(from, Quaternion.LookRotation(to - from, up), Vector3.one);

        /// <summary>OpenGL's clip space (-1 to 1, looking down -z), whatever the platform.</summary>
        public static Matrix4x4 Ortho(float left, float right, float bottom, float top, float zNear, float zFar)
        {
            Matrix4x4 m = identity;
            m.m00 = 2 / (right - left);
            m.m11 = 2 / (top - bottom);
            m.m22 = -2 / (zFar - zNear);
            m.m03 = -(right + left) / (right - left);
            m.m13 = -(top + bottom) / (top - bottom);
            m.m23 = -(zFar + zNear) / (zFar - zNear);
            return m;
        }

        /// <summary>OpenGL's clip space; the vertical angle in degrees.</summary>
        public static Matrix4x4 Perspective(float fov, float aspect, float zNear, float zFar)
        {
            float top = zNear * MathF.Tan(fov * Mathf.Deg2Rad * 0.5f);
            return Frustum(-top * aspect, top * aspect, -top, top, zNear, zFar);
        }

        public static Matrix4x4 Frustum(FrustumPlanes fp) => Frustum(fp.left, fp.right, fp.bottom, fp.top, fp.zNear, fp.zFar);

        public static Matrix4x4 Frustum(float left, float right, float bottom, float top, float zNear, float zFar)
        {
            Matrix4x4 m = default;
            m.m00 = 2 * zNear / (right - left);
            m.m11 = 2 * zNear / (top - bottom);
            m.m02 = (right + left) / (right - left);
            m.m12 = (top + bottom) / (top - bottom);
            m.m22 = -(zFar + zNear) / (zFar - zNear);
            m.m23 = -2 * zFar * zNear / (zFar - zNear);
            m.m32 = -1;
            return m;
        }

        public static Matrix4x4 Transpose(Matrix4x4 m) => new Matrix4x4(m.GetRow(0), m.GetRow(1), m.GetRow(2), m.GetRow(3));

        public static float Determinant(Matrix4x4 m)
        {
            Minors n = new Minors(m);
            return (float)n.Determinant;
        }

        /// <summary>All zeros when there is none.</summary>
        public static Matrix4x4 Inverse(Matrix4x4 m)
        {
            Minors n = new Minors(m);
            double determinant = n.Determinant;
            if (determinant == 0)
                return zero;
            double d = 1 / determinant;
            Matrix4x4 r;
            r.m00 = (float)((m.m11 * n.c5 - m.m12 * n.c4 + m.m13 * n.c3) * d);
            r.m01 = (float)((-m.m01 * n.c5 + m.m02 * n.c4 - m.m03 * n.c3) * d);
            r.m02 = (float)((m.m31 * n.s5 - m.m32 * n.s4 + m.m33 * n.s3) * d);
            r.m03 = (float)((-m.m21 * n.s5 + m.m22 * n.s4 - m.m23 * n.s3) * d);
            r.m10 = (float)((-m.m10 * n.c5 + m.m12 * n.c2 - m.m13 * n.c1) * d);
            r.m11 = (float)((m.m00 * n.c5 - m.m02 * n.c2 + m.m03 * n.c1) * d);
            r.m12 = (float)((-m.m30 * n.s5 + m.m32 * n.s2 - m.m33 * n.s1) * d);
            r.m13 = (float)((m.m20 * n.s5 - m.m22 * n.s2 + m.m23 * n.s1) * d);
            r.m20 = (float)((m.m10 * n.c4 - m.m11 * n.c2 + m.m13 * n.c0) * d);
            r.m21 = (float)((-m.m00 * n.c4 + m.m01 * n.c2 - m.m03 * n.c0) * d);
            r.m22 = (float)((m.m30 * n.s4 - m.m31 * n.s2 + m.m33 * n.s0) * d);
            r.m23 = (float)((-m.m20 * n.s4 + m.m21 * n.s2 - m.m23 * n.s0) * d);
            r.m30 = (float)((-m.m10 * n.c3 + m.m11 * n.c1 - m.m12 * n.c0) * d);
            r.m31 = (float)((m.m00 * n.c3 - m.m01 * n.c1 + m.m02 * n.c0) * d);
            r.m32 = (float)((-m.m30 * n.s3 + m.m31 * n.s1 - m.m32 * n.s0) * d);
            r.m33 = (float)((m.m20 * n.s3 - m.m21 * n.s1 + m.m22 * n.s0) * d);
            return r;
        }

        public static bool Inverse3DAffine(Matrix4x4 input, ref Matrix4x4 result)
        {
            Matrix4x4 affine = input;
            affine.SetRow(3, new Vector4(0, 0, 0, 1));
            if (new Minors(affine).Determinant == 0)
            {
                result = identity;
                return false;
            }
            result = Inverse(affine);
            return true;
        }

        // The 2x2 minors of the upper and the lower two rows (Laplace expansion), in double: views and projections differ by 1e6 in scale.
        readonly struct Minors
        {
            public readonly double s0, s1, s2, s3, s4, s5, c0, c1, c2, c3, c4, c5;

            public Minors(in Matrix4x4 m)
            {
                s0 = (double)m.m00 * m.m11 - (double)m.m10 * m.m01;
                s1 = (double)m.m00 * m.m12 - (double)m.m10 * m.m02;
                s2 = (double)m.m00 * m.m13 - (double)m.m10 * m.m03;
                s3 = (double)m.m01 * m.m12 - (double)m.m11 * m.m02;
                s4 = (double)m.m01 * m.m13 - (double)m.m11 * m.m03;
                s5 = (double)m.m02 * m.m13 - (double)m.m12 * m.m03;
                c5 = (double)m.m22 * m.m33 - (double)m.m32 * m.m23;
                c4 = (double)m.m21 * m.m33 - (double)m.m31 * m.m23;
                c3 = (double)m.m21 * m.m32 - (double)m.m31 * m.m22;
                c2 = (double)m.m20 * m.m33 - (double)m.m30 * m.m23;
                c1 = (double)m.m20 * m.m32 - (double)m.m30 * m.m22;
                c0 = (double)m.m20 * m.m31 - (double)m.m30 * m.m21;
            }

            public double Determinant => s0 * c5 - s1 * c4 + s2 * c3 + s3 * c2 - s4 * c1 + s5 * c0;
        }

        /// <summary>With perspective division.</summary>
        public Vector3 MultiplyPoint(Vector3 point)
        {
            Vector3 p = MultiplyPoint3x4(point);
            float w = m30 * point.x + m31 * point.y + m32 * point.z + m33;
            return p / w;
        }

        public Vector3 MultiplyPoint3x4(Vector3 point) => new Vector3(
            m00 * point.x + m01 * point.y + m02 * point.z + m03,
            m10 * point.x + m11 * point.y + m12 * point.z + m13,
            m20 * point.x + m21 * point.y + m22 * point.z + m23);

        public Vector3 MultiplyVector(Vector3 vector) => new Vector3(
            m00 * vector.x + m01 * vector.y + m02 * vector.z,
            m10 * vector.x + m11 * vector.y + m12 * vector.z,
            m20 * vector.x + m21 * vector.y + m22 * vector.z);

        public Plane TransformPlane(Plane plane)
        {
            Vector3 n = plane.normal;
            Vector4 p = inverse.transpose * new Vector4(n.x, n.y, n.z, plane.distance);
            return new Plane(p, p.w);
        }

        public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs)
            => new Matrix4x4(lhs * rhs.GetColumn(0), lhs * rhs.GetColumn(1), lhs * rhs.GetColumn(2), lhs * rhs.GetColumn(3));

        public static Vector4 operator *(Matrix4x4 lhs, Vector4 vector) => new Vector4(
            lhs.m00 * vector.x + lhs.m01 * vector.y + lhs.m02 * vector.z + lhs.m03 * vector.w,
            lhs.m10 * vector.x + lhs.m11 * vector.y + lhs.m12 * vector.z + lhs.m13 * vector.w,
            lhs.m20 * vector.x + lhs.m21 * vector.y + lhs.m22 * vector.z + lhs.m23 * vector.w,
            lhs.m30 * vector.x + lhs.m31 * vector.y + lhs.m32 * vector.z + lhs.m33 * vector.w);

        public static bool operator ==(Matrix4x4 lhs, Matrix4x4 rhs)
            => lhs.GetColumn(0) == rhs.GetColumn(0) && lhs.GetColumn(1) == rhs.GetColumn(1) && lhs.GetColumn(2) == rhs.GetColumn(2)
                && lhs.GetColumn(3) == rhs.GetColumn(3);
        public static bool operator !=(Matrix4x4 lhs, Matrix4x4 rhs) => !(lhs == rhs);

        public bool Equals(Matrix4x4 other)
            => GetColumn(0).Equals(other.GetColumn(0)) && GetColumn(1).Equals(other.GetColumn(1)) && GetColumn(2).Equals(other.GetColumn(2))
                && GetColumn(3).Equals(other.GetColumn(3));
        public override bool Equals(object other) => other is Matrix4x4 m && Equals(m);
        public override int GetHashCode() => HashCode.Combine(GetColumn(0), GetColumn(1), GetColumn(2), GetColumn(3));
        public override string ToString() => ToString(null, null);
        public string ToString(string format) => ToString(format, null);

        public string ToString(string format, IFormatProvider formatProvider)
        {
            format = string.IsNullOrEmpty(format) ? "F5" : format;
            formatProvider ??= CultureInfo.InvariantCulture;
            var text = new System.Text.StringBuilder();
            for (int row = 0; row < 4; row++)
                for (int column = 0; column < 4; column++)
                    text.Append(this[row, column].ToString(format, formatProvider)).Append(column < 3 ? '\t' : '\n');
            return text.ToString();
        }
    }

    public struct FrustumPlanes
    {
        public float left;
        public float right;
        public float bottom;
        public float top;
        public float zNear;
        public float zFar;
    }
}
