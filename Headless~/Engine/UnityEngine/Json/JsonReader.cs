using System;
using System.Collections.Generic;
using System.Globalization;
using System.Text;

namespace UnityEngine.Headless
{
    /// <summary>JSON to dictionaries, lists, strings, doubles, bools and null.</summary>
    internal sealed class JsonReader
    {
        readonly string json;
        int at;

        JsonReader(string json) { this.json = json; }

        /// <exception cref="ArgumentException">With the position of the fault.</exception>
        public static object Read(string json)
        {
            var reader = new JsonReader(json);
            object value = reader.Value();
            reader.Blank();
            return reader.at == json.Length ? value : throw reader.Fault("The document root must not follow by other values.");
        }

        ArgumentException Fault(string what) => new ArgumentException($"JSON parse error: {what} (at character {at + 1})");

        void Blank()
        {
            while (at < json.Length && char.IsWhiteSpace(json[at]))
                at++;
        }

        char Next()
        {
            Blank();
            return at < json.Length ? json[at] : throw Fault("The document ends within a value.");
        }

        void Expect(char c)
        {
            if (Next() != c)
                throw Fault($"'{c}' is missing.");
            at++;
        }

        object Value()
        {
            switch (Next())
            {
                case '{': return Group();
                case '[': return List();
                case '"': return Text();
                case 't': return Word("true", true);
                case 'f': return Word("false", false);
                case 'n': return Word("null", null);
                default: return Number();
            }
        }

        object Word(string word, object value)
        {
            if (string.CompareOrdinal(json, at, word, 0, word.Length) != 0)
                throw Fault("Invalid value.");
            at += word.Length;
            return value;
        }

        Dictionary<string, object> Group()
        {
            var group = new Dictionary<string, object>();
            Expect('{');
            if (Next() == '}')
            {
                at++;
                return group;
            }
            while (true)
            {
                Blank();
                string name = Text();
                Expect(':');
                group[name] = Value();
                if (Next() == ',')
                {
                    at++;
                    continue;
                }
                Expect('}');
                return group;
            }
        }

        List<object> List()
        {
            var list = new List<object>();
            Expect('[');
            if (Next() == ']')
            {
                at++;
                return list;
            }
            while (true)
            {
                list.Add(Value());
                if (Next() == ',')
                {
                    at++;
                    continue;
                }
                Expect(']');
                return list;
            }
        }

        string Text()
        {
            Expect('"');
            var text = new StringBuilder();
            while (true)
            {
                if (at >= json.Length)
                    throw Fault("Missing a closing quotation mark in string.");
                char c = json[at++];
                if (c == '"')
                    return text.ToString();
                if (c != '\\')
                {
                    text.Append(c);
                    continue;
                }
                if (at >= json.Length)
                    throw Fault("Invalid escape character in string.");
                char escaped = json[at++];
                int index = "\"\\/bfnrt".IndexOf(escaped);
                if (index >= 0)
                    text.Append("\"\\/\b\f\n\r\t"[index]);
                else if (escaped == 'u' && at + 4 <= json.Length
                    && ushort.TryParse(json.Substring(at, 4), NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture,
                    out ushort code))
                {
                    text.Append((char)code);
                    at += 4;
                }
                else
                    throw Fault("Invalid escape character in string.");
            }
        }

        object Number()
        {
            int start = at;
            while (at < json.Length && (char.IsDigit(json[at]) || "+-.eE".IndexOf(json[at]) >= 0))
                at++;
            return double.TryParse(json.Substring(start, at - start), NumberStyles.Float, CultureInfo.InvariantCulture, out double number)
                ? number : throw Fault("Invalid value.");
        }
    }
}
