using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Host.Assets
{
    /// <summary>Unity writes lists of whole numbers as one run of hexadecimal digits, each number's lowest byte first.</summary>
    internal static class PackedNumbers
    {
        /// <summary>False when text is not such a run or ends within a number.</summary>
        public static bool TryRead(Type element, string text, List<object> items)
        {
            var type = element.IsEnum ? Enum.GetUnderlyingType(element) : element;
            var size = type == typeof(bool) ? 1 : type == typeof(char) ? 2 : Marshal.SizeOf(type);
            if (!TryBytes(text, out var bytes) || bytes.Length % size != 0) return false;
            for (var at = 0; at < bytes.Length; at += size)
            {
                var number = Number(type, bytes.AsSpan(at, size));
                items.Add(element.IsEnum ? Enum.ToObject(element, number) : number);
            }
            return true;
        }

        public static bool TryBytes(string text, out byte[] bytes)
        {
            bytes = null;
            if (text.Length % 2 != 0) return false;
            foreach (var c in text)
                if (!Uri.IsHexDigit(c)) return false;
            bytes = Convert.FromHexString(text);
            return true;
        }

        static object Number(Type type, ReadOnlySpan<byte> bytes) => Type.GetTypeCode(type) switch
        {
            TypeCode.Boolean => bytes[0] != 0,
            TypeCode.Byte => bytes[0],
            TypeCode.SByte => unchecked((sbyte)bytes[0]),
            TypeCode.Char => (char)BitConverter.ToUInt16(bytes),
            TypeCode.Int16 => BitConverter.ToInt16(bytes),
            TypeCode.UInt16 => BitConverter.ToUInt16(bytes),
            TypeCode.Int32 => BitConverter.ToInt32(bytes),
            TypeCode.UInt32 => BitConverter.ToUInt32(bytes),
            TypeCode.Int64 => BitConverter.ToInt64(bytes),
            TypeCode.UInt64 => BitConverter.ToUInt64(bytes),
            TypeCode.Single => BitConverter.ToSingle(bytes),
            _ => BitConverter.ToDouble(bytes),
        };
    }
}
