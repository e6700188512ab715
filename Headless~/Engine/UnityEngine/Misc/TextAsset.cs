using System.Text;

namespace UnityEngine
{
    public class TextAsset : Object
    {
        readonly byte[] data;

        public TextAsset() : this("") { }
        public TextAsset(string text) { data = Encoding.UTF8.GetBytes(text ?? ""); }
        /// <summary>A file's bytes, which need not be text.</summary>
        internal TextAsset(byte[] content) { data = content; }

        public byte[] bytes => (byte[])data.Clone();
        public long dataSize => data.Length;
        public string text => Encoding.UTF8.GetString(data);
        public override string ToString() => text;
    }
}
