using System.Collections.Generic;
using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace Host.Manual
{
    /// <summary>Texts of the search as a script: a page that is opened as a file may not load data.</summary>
    sealed class SearchDocuments
    {
        static readonly JsonSerializerOptions Plain = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

        readonly List<string> rows = new();

        /// <param name="title">Heading or name.</param>
        /// <param name="place">Page that it is on.</param>
        public void Add(string address, string title, string section, string text)
            => rows.Add(JsonSerializer.Serialize(new[] { address, title, section, text }, Plain));

        public string Script()
        {
            var script = new StringBuilder("// Address, title, place and text of what the manual's search looks through.\nmanualDocuments([\n");
            foreach (string row in rows)
                script.Append(row).Append(",\n");
            return script.Append("]);\n").ToString();
        }
    }
}
