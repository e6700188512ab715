using System;
using System.Globalization;
using System.IO;

namespace Host.Assets
{
    /// <summary>Parts of a .meta file that the host needs. Read line by line: a project has thousands of them.</summary>
    internal readonly struct MetaFile
    {
        public readonly string Guid, Importer;
        /// <summary>Order of scripts set in Project Settings > Script Execution Order.</summary>
        public readonly int ExecutionOrder;

        MetaFile(string guid, string importer, int executionOrder) { Guid = guid; Importer = importer; ExecutionOrder = executionOrder; }

        /// <summary>False with the reason in problem without a usable GUID.</summary>
        public static bool TryRead(string file, string shownAs, out MetaFile meta, out string problem)
        {
            string guid = null, importer = "";
            var order = 0;
            problem = null;
            var line = 0;
            foreach (var text in File.ReadLines(file))
            {
                line++;
                if (text.StartsWith("guid:", StringComparison.Ordinal)) guid = text.Substring(5).Trim();
                else if (text.Length > 0 && text[0] != ' ' && text.EndsWith("Importer:", StringComparison.Ordinal))
                    importer = text.Substring(0, text.Length - 1);
                else if (text.StartsWith("  executionOrder:", StringComparison.Ordinal)
                    && !int.TryParse(text.AsSpan(17).Trim(), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out order))
                    problem = $"{shownAs}({line}): the execution order '{text.Substring(17).Trim()}' is not a whole number";
            }
            meta = new MetaFile(guid, importer, order);
            if (guid == null)
                problem =
                $"{shownAs}: this file has no guid: delete it and let Unity or Headless~/Engine/tools/make-meta write a new one";
            else if (!IsGuid(guid)) problem = $"{shownAs}: the guid '{guid}' is not 32 lower-case hexadecimal digits: delete the file " +
                $"and let Unity or Headless~/Engine/tools/make-meta write a new one";
            return problem == null;
        }

        public static bool IsGuid(string text)
        {
            if (text == null || text.Length != 32) return false;
            foreach (var c in text)
                if (!(c >= '0' && c <= '9' || c >= 'a' && c <= 'f')) return false;
            return true;
        }
    }
}
